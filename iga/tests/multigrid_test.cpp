#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/link.hpp"
#include "geometry/models/sphere.hpp"
#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/multigrid/fast_diagonalization.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/multigrid/level_transfer.hpp"
#include "iga/multigrid/separable_coefficients.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;
using testing::distorted_box;
using ::testing::HasSubstr;
using testing::problem;
using testing::steel;

// Held obliquely and pulled: all kinds of frames.
ElasticityProblem held_box(const DiscretizationOptions& options) {
  ElasticityProblem p = problem(distorted_box(), options, steel);
  const auto& model = p.discretization.model;
  p.supports = {
      {"plane", boundary(model, "x_min"), PlaneSupport{}},
      {"roller", boundary(model, "y_min"), PrescribedDisplacement{{std::nullopt, 1e-4, std::nullopt}}},
      {"clamp", boundary(model, "z_min"), PrescribedDisplacement{{0.0, 1e-4, 0.0}}}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e8, 2e7, -3e7})};
  return p;
}

struct Levels {
  explicit Levels(const ElasticityProblem& p)
      : global(global_nodes(p.discretization)),
        frames(support_frames(p, global)),
        distribution(distribute(isoparametric_spaces(p.discretization), 1)),
        fine(finest_level(isoparametric_spaces(p.discretization), global, frames, distribution, {})),
        coarse(coarser_level(p.discretization.model, fine, fine, frames, distribution, {}).value()) {}
  GlobalNodes global;
  std::vector<SupportFrame> frames;
  Distribution distribution;
  Level fine;
  Level coarse;
};

// Seeded unknowns, 0 where supports fix them.
Eigen::VectorXd some_unknowns(const Level& level, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::VectorXd x(3 * level.rows.local_rows());
  for (double& entry : x) entry = value(random);
  return level.free.to_free(level.free.to_space(x));
}

TEST(CoarserKnots, AreNestedAndTheSameFromBothEnds) {
  for (int elements = 1; elements <= 20; ++elements) {
    const geometry::KnotVector fine = geometry::KnotVector::uniform(3, elements, 2);
    const geometry::KnotVector coarse = coarser_knots(fine);
    const int odd = elements % 4 == 1 ? 1 : elements % 4 == 3 ? -1 : 0;  // one or three left in the middle
    EXPECT_EQ(coarse.element_count(), (elements + odd) / 2) << elements;
    EXPECT_TRUE(
        geometry::same_space(geometry::reversed(coarse), coarser_knots(geometry::reversed(fine)), 1e-14));
    const auto transfer = geometry::transfer(coarse, fine);  // fails if they were not nested
    EXPECT_EQ(transfer.rows(), fine.size()) << elements;
    EXPECT_EQ(transfer.cols(), coarse.size()) << elements;
  }
}

TEST(LevelTransfer, RestrictionIsTheTransposeOfProlongation) {
  const ElasticityProblem p = held_box({.degree = {3, 2, 3}, .refine = 1});
  const Levels levels(p);
  const LevelTransfer transfer(levels.coarse, levels.fine);
  const Eigen::VectorXd x = some_unknowns(levels.coarse, 1);
  const Eigen::VectorXd f = some_unknowns(levels.fine, 2);
  const double one = transfer.to_finer(x).dot(f);
  EXPECT_NEAR(one, x.dot(transfer.from_finer(f)), 1e-13 * x.norm() * f.norm());
  EXPECT_GT(std::abs(one), 1e-3);
}

TEST(LevelTransfer, KeepsTheEnergyOfNestedSpaces) {
  // Polynomial patches: the coarse space is part of the fine one, so a displacement costs the same on both.
  ElasticityProblem p = problem(distorted_box(), {.degree = {3, 3, 3}, .refine = 1}, steel);
  p.supports = {{"clamp", boundary(p.discretization.model, "z_min"), PrescribedDisplacement{}}};
  const Levels levels(p);
  const LevelTransfer transfer(levels.coarse, levels.fine);
  const Eigen::VectorXd x = some_unknowns(levels.coarse, 3);
  const Eigen::VectorXd y = transfer.to_finer(x);
  // The same quadrature points would be needed for round-off; many points are as good.
  const double coarse = x.dot(LevelOperator(levels.coarse, p.materials, 12).apply(x));
  const double fine = y.dot(LevelOperator(levels.fine, p.materials, 12).apply(y));
  EXPECT_NEAR(fine / coarse, 1, 1e-6);
}

TEST(LevelTransfer, KeepsTheEnergyOfRationalSpacesDownToTheGeometrysOwn) {
  ElasticityProblem p = problem(geometry::connect(geometry::link_model({})), {.degree = {3, 3, 3}}, steel);
  p.supports = {{"clamp", boundary(p.discretization.model, "bore_left"), PrescribedDisplacement{}}};
  const Levels levels(p);  // from degree 3 to 2, one element each
  ASSERT_EQ(levels.coarse.spaces[0].knots[0].degree(), 2);
  const LevelTransfer transfer(levels.coarse, levels.fine);
  const Eigen::VectorXd x = some_unknowns(levels.coarse, 3);
  const Eigen::VectorXd f = some_unknowns(levels.fine, 4);
  const Eigen::VectorXd y = transfer.to_finer(x);
  EXPECT_NEAR(y.dot(f), x.dot(transfer.from_finer(f)), 1e-13 * x.norm() * f.norm());
  const double coarse = x.dot(LevelOperator(levels.coarse, p.materials, 20).apply(x));
  const double fine = y.dot(LevelOperator(levels.fine, p.materials, 20).apply(y));
  EXPECT_NEAR(fine / coarse, 1, 1e-6);
}

TEST(SeparableCoefficients, AreExactForAGradedBox) {
  // x = u + u^2 and so on with other sizes: every coefficient is a product of functions of one parameter.
  const geometry::KnotVector knots = geometry::KnotVector::bezier(2, 0, 1);
  Eigen::Matrix3Xd points(3, 27);
  const std::array<double, 3> graded = {0, 0.5, 2};
  for (std::size_t a = 0; a < 27; ++a)
    points.col(static_cast<Eigen::Index>(a)) << graded[a % 3], 3 * graded[a / 3 % 3], 5 * graded[a / 9];
  const geometry::NurbsVolume patch({knots, knots, knots}, points);
  const auto found = separable_coefficients(patch, steel);
  const std::array<double, 3> at = {3.5 / 8, 1.5 / 8, 6.5 / 8};  // a sample, where no interpolation enters
  const Eigen::Matrix3d jacobian = patch.jacobian({at[0], at[1], at[2]});
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t d = 0; d < 3; ++d) {
      double product = found[c].factor[d];
      for (std::size_t e = 0; e < 3; ++e)
        product *= (e == d ? found[c].stiffness[e] : found[c].mass[e]).at(at[e]);
      const auto k = static_cast<Eigen::Index>(d);
      const double modulus = steel.mu + (c == d ? steel.lambda + steel.mu : 0);
      const double exact = modulus * jacobian.determinant() / (jacobian(k, k) * jacobian(k, k));
      EXPECT_NEAR(product / exact, 1, 1e-12) << c << d;
    }
}

// The condition of B A on the unknowns that supports leave free.
double condition(const ElasticityProblem& p) {
  const Levels levels(p);
  const LevelOperator stiffness(levels.fine, p.materials, 0);
  const FastDiagonalization smoother(p.discretization.model, levels.fine, p.materials, stiffness.diagonal(),
                                     stiffness.surfaces());
  const Eigen::Index n = 3 * levels.fine.rows.local_rows();
  Eigen::MatrixXd a(n, n);
  Eigen::MatrixXd b(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd unit =
        levels.fine.free.to_free(levels.fine.free.to_space(Eigen::VectorXd::Unit(n, i)));
    a.col(i) = stiffness.apply(unit);
    b.col(i) = smoother.apply(unit);
  }
  EXPECT_LT((b - b.transpose()).norm(), 1e-12 * b.norm());
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < n; ++i)
    if (a(i, i) > 0) free.push_back(i);
  const Eigen::MatrixXd a_free = a(free, free);
  const Eigen::MatrixXd b_free = b(free, free);
  // B A has the eigenvalues of the pencil (A, B^-1).
  const Eigen::VectorXd values = symmetric_eigen(a_free, pseudo_inverse(b_free)).values;
  EXPECT_GT(values.minCoeff<Eigen::PropagateNaN>(), 0);
  return values.maxCoeff<Eigen::PropagateNaN>() / values.minCoeff<Eigen::PropagateNaN>();
}

TEST(FastDiagonalization, IsAsGoodForEveryDegreeOnABoxHeldAllAround) {
  for (int degree = 1; degree <= 4; ++degree) {
    ElasticityProblem p = problem(geometry::connect(geometry::box_model({.size = {1, 2, 0.5}})),
                                  {.degree = {degree, degree, degree}, .refine = 1}, steel);
    p.supports = {{"all", p.discretization.model.boundary_faces(), PrescribedDisplacement{}}};
    EXPECT_LT(condition(p), 7) << degree;  // of the components' coupling alone; point blocks reach hundreds
  }
}

TEST(FastDiagonalization, IsPositiveDefiniteWithAllKindsOfSupports) {
  EXPECT_LT(condition(held_box({.degree = {2, 2, 2}})), 1e4);
}

void expect_same(const ElasticityProblem& p, Coupling coupling, solvers::Method direct,
                 solvers::SolverOptions options, int most_iterations) {
  options.tolerance = 1e-11;
  const ElasticitySolution expected =
      solve_elasticity(p, {.coupling = coupling, .solver = {.method = direct}});
  const ElasticitySolution found = solve_elasticity(p, {.coupling = coupling, .solver = options});
  EXPECT_EQ(found.solver.method, options.method);
  EXPECT_GT(found.solver.levels, 1);
  EXPECT_LE(found.solver.iterations, most_iterations);
  EXPECT_NEAR(found.results.internal_energy / expected.results.internal_energy, 1, 1e-9);
  double error = 0;
  double size = 0;
  for (std::size_t k = 0; k < p.discretization.patches.size(); ++k) {
    error = isopatch::larger(error, (found.field.displacement[k] - expected.field.displacement[k])
                                        .cwiseAbs()
                                        .maxCoeff<Eigen::PropagateNaN>());
    size = isopatch::larger(size, expected.field.displacement[k].cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  EXPECT_LT(error, 1e-9 * size);
  ASSERT_EQ(found.multipliers.size(), expected.multipliers.size());
  double force_error = 0;
  double force = 0;
  for (std::size_t k = 0; k < found.multipliers.size(); ++k) {
    force_error =
        isopatch::larger(force_error, (found.multipliers[k].force - expected.multipliers[k].force).norm());
    force = isopatch::larger(force, expected.multipliers[k].force.norm());
  }
  EXPECT_LT(force_error, 1e-7 * force);
}

TEST(Multigrid, FindsTheDirectSolutionWithAndWithoutAMatrix) {
  const ElasticityProblem p = held_box({.degree = {3, 3, 3}, .refine = 1});
  for (const auto form : {solvers::Operator::assembled, solvers::Operator::matrix_free})
    expect_same(p, Coupling::elimination, solvers::Method::cholmod,
                {.method = solvers::Method::cg, .form = form}, 40);
}

TEST(Multigrid, FindsTheDirectSolutionForMultipliers) {
  expect_same(held_box({.degree = {3, 3, 3}, .refine = 1}), Coupling::lagrange, solvers::Method::mumps,
              {.method = solvers::Method::minres}, 120);
}

TEST(Multigrid, WorksOnRationalPatchesThatMeetInThemselves) {
  const geometry::MultiPatch model = geometry::connect(geometry::sphere_model({}));
  ElasticityProblem p = problem(model, {.degree = {3, 3, 3}, .refine = 2}, steel);
  for (const geometry::Boundary& b : model.boundaries()) {
    if (b.name.find("outer") == std::string::npos && b.name.find("inner") == std::string::npos)
      p.supports.push_back({b.name, b.faces, PlaneSupport{}});
    else
      p.surface_loads.push_back(pressure_load(b.name, b.faces, 1e8));
  }
  expect_same(p, Coupling::elimination, solvers::Method::cholmod, {.method = solvers::Method::cg}, 60);
}

TEST(Multigrid, NeedsAsManyIterationsForEveryDegreeAndMesh) {
  int fewest = 1000;
  int most = 0;
  for (int degree = 1; degree <= 4; ++degree)
    for (int refine = 2; refine <= (degree < 3 ? 4 : 3); ++refine) {
      ElasticityProblem p = problem(geometry::connect(geometry::box_model({})),
                                    {.degree = {degree, degree, degree}, .refine = refine}, steel);
      p.supports = {{"clamp", boundary(p.discretization.model, "x_min"), PrescribedDisplacement{}}};
      p.surface_loads = {constant_traction("pull", boundary(p.discretization.model, "x_max"), {1, 2, 3})};
      if (3 * p.discretization.node_count() < 2500) continue;  // the coarsest level is factorized
      const ElasticitySolution s =
          solve_elasticity(p, {.solver = {.method = solvers::Method::cg, .tolerance = 1e-8}});
      fewest = isopatch::smaller(fewest, s.solver.iterations);
      most = isopatch::larger(most, s.solver.iterations);
    }
  EXPECT_GT(fewest, 2);
  EXPECT_LE(most, 2 * fewest);
}

// Fewest and most iterations to 1e-8 on the link over degrees 1 to 4.
std::array<int, 2> iterations_on_the_link(Coupling coupling, solvers::Method method) {
  std::array<int, 2> result = {1000, 0};
  for (int degree = 1; degree <= 4; ++degree) {
    ElasticityProblem p = problem(geometry::connect(geometry::link_model({})),
                                  {.degree = {degree, degree, degree}, .refine = 2}, steel);
    p.supports = {{"clamp", boundary(p.discretization.model, "bore_left"), PrescribedDisplacement{}}};
    p.surface_loads = {constant_traction("pull", boundary(p.discretization.model, "bore_right"), {5, -1, 0})};
    const ElasticitySolution s =
        solve_elasticity(p, {.coupling = coupling, .solver = {.method = method, .tolerance = 1e-8}});
    result = {isopatch::smaller(result[0], s.solver.iterations),
              isopatch::larger(result[1], s.solver.iterations)};
  }
  return result;
}

TEST(Multigrid, NeedsAsManyIterationsForEveryDegreeOnCurvedThinPatches) {
  const auto [fewest, most] = iterations_on_the_link(Coupling::elimination, solvers::Method::cg);
  EXPECT_GT(fewest, 2);
  EXPECT_LE(most, 14);  // 21 with mean coefficients and a coarsest level of degree 1
  EXPECT_LE(most, 2 * fewest);
}

// Of tubes of which springs ten thousand times as stiff hold the radial displacement: 60 to 130 where the
// held faces are smoothed with the patches' insides.
TEST(Multigrid, NeedsFewMoreIterationsWhereSpringsStandForHolds) {
  const geometry::MultiPatch model = geometry::connect(
      geometry::cylinder_model({.inner_radius = 0.4, .outer_radius = 1, .height = 2, .axial_patches = 2}));
  for (const int degree : {2, 3}) {
    ElasticityProblem p = problem(model, {.degree = {degree, degree, degree}, .refine = 2}, testing::steel);
    p.supports = {{"shell", boundary(model, "outer"), CylindricalSupport{}}};
    for (const char* plane : {"start", "bottom"})
      p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
    p.surface_loads = {constant_traction("push", boundary(model, "inner"), {1e6, 0, 3e5})};
    const auto s = solve_elasticity(p, {.solver = {.method = solvers::Method::cg, .tolerance = 1e-8}});
    EXPECT_LE(s.solver.iterations, 12) << degree;
  }
}

TEST(Multigrid, NeedsHardlyMoreIterationsForMultipliers) {
  const auto [fewest, most] = iterations_on_the_link(Coupling::lagrange, solvers::Method::minres);
  EXPECT_GT(fewest, 2);
  EXPECT_LE(most, 16);  // 25 with jumps that are differences of unknowns, and a hundredth as stiff
  EXPECT_LE(most, 2 * fewest);
}

TEST(ChooseSolver, RefusesWhatCannotFitBeforeAssembly) {
  const ElasticityProblem p = held_box({.degree = {3, 3, 3}, .refine = 1});
  for (const auto method : {solvers::Method::automatic, solvers::Method::cholmod, solvers::Method::cg}) {
    try {
      solve_elasticity(p, {.solver = {.method = method, .memory_limit = 1e5}});
      FAIL() << "nothing was refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::out_of_memory);
      EXPECT_THAT(error.what(), HasSubstr(" unknowns would fit"));
      EXPECT_THAT(error.what(), ::testing::Not(HasSubstr("about 0")));
    }
  }
}

// The finest level with degree + 1 Gauss points.
Level with_fewest_points(Level level) {
  for (PatchSpace& space : level.spaces) space.points = {0, 0, 0};
  return level;
}

TEST(ElasticityMultigrid, SmoothsWithDegreePlusOneGaussPointsWhereNoMatrixIsAtHand) {
  const geometry::MultiPatch ring = geometry::connect(geometry::cylinder_model());
  ElasticityProblem p = problem(ring, {.degree = {2, 2, 2}, .refine = 1}, steel);
  p.supports = {{"clamp", boundary(ring, "start"), PrescribedDisplacement{}}};
  const Levels levels(p);
  ASSERT_GT(levels.fine.spaces[0].points[1], 3);  // an arc asks for more
  const Level few = with_fewest_points(levels.fine);
  const LevelOperator many_points(levels.fine, p.materials, 0), few_points(few, p.materials, 0);
  const auto preconditioned = [&](const solvers::LinearOperator& product) {
    const ElasticityMultigrid multigrid(p, levels.fine, levels.frames, levels.distribution, {}, product,
                                        {.coarsest_dofs = 50, .coarsest_curved_dofs = 50}, {});
    return multigrid.apply(some_unknowns(levels.fine, 7));
  };
  const Eigen::VectorXd found = preconditioned({});
  const ElasticityMultigrid of_few(p, few, levels.frames, levels.distribution, {},
                                   [&](const Eigen::VectorXd& x) { return few_points.apply(x); },
                                   {.coarsest_dofs = 50, .coarsest_curved_dofs = 50}, {});
  EXPECT_EQ(found, of_few.apply(some_unknowns(few, 7)));
  const Eigen::VectorXd with_matrix =
      preconditioned([&](const Eigen::VectorXd& x) { return many_points.apply(x); });
  EXPECT_GT((found - with_matrix).norm(), 1e-8 * found.norm());
  EXPECT_LT((found - with_matrix).norm(), 1e-2 * found.norm());
}

}  // namespace
}  // namespace isopatch::iga
