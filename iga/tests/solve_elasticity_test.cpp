#include "iga/solution/solve_elasticity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;
using testing::distorted_box;
using ::testing::HasSubstr;
using testing::problem;
using testing::steel;

// Largest difference of the coefficients from those of u = gradient * x, relative to the largest one.
double affine_error(const ElasticField& field, const Eigen::Matrix3d& gradient) {
  double error = 0;
  double size = 0;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const Eigen::Matrix3Xd exact = gradient * field.patches[p].control_points();
    error =
        isopatch::larger(error, (field.displacement[p] - exact).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    size = isopatch::larger(size, exact.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  return error / size;
}

TEST(SolveElasticity, PassesThePatchTestOnADistortedBoxInBothCouplings) {
  Eigen::Matrix3d gradient;
  gradient << 1e-3, 2e-4, -3e-4, 5e-4, -7e-4, 1e-4, 2e-4, 6e-4, 4e-4;
  for (const Coupling coupling : all_couplings) {
    ElasticityProblem p = problem(distorted_box(), {.refine = 1}, steel);
    p.supports = {
        {"boundary", p.discretization.model.boundary_faces(), PrescribedDisplacement{.gradient = gradient}}};
    const ElasticitySolution solution = solve_elasticity(p, {.coupling = coupling});
    EXPECT_LT(affine_error(solution.field, gradient), 1e-10) << name(coupling);
    const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
    EXPECT_NEAR(solution.results.internal_energy / (0.5 * stress(strain, steel).cwiseProduct(strain).sum()),
                1, 1e-11);
    EXPECT_NEAR(solution.results.external_work / solution.results.internal_energy, 1, 1e-10);
  }
}

TEST(SolveElasticity, StretchesABarByTractionAgainstSymmetryPlanes) {
  for (const Coupling coupling : all_couplings) {
    ElasticityProblem p = problem(distorted_box(), {}, steel);
    const auto& model = p.discretization.model;
    for (const char* plane : {"x_min", "y_min", "z_min"})
      p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
    p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e8, 0, 0})};
    const ElasticitySolution solution = solve_elasticity(p, {.coupling = coupling});
    const double strain = 1e8 / 210e9;
    EXPECT_LT(
        affine_error(solution.field, Eigen::Vector3d(strain, -0.3 * strain, -0.3 * strain).asDiagonal()),
        1e-10);
    EXPECT_NEAR(solution.results.max_von_mises.value, 1e8, 1e-1);
    EXPECT_NEAR(solution.results.reactions[0].force[0], -1e8, 1e-1);
    EXPECT_NEAR(solution.results.reactions[1].force.norm(), 0, 1e-1);
  }
}

// Lame's thick-walled cylinder: a = 1, b = 2, E = 1000, pressure 10 inside, plane strain.
double cylinder_error(double nu, int degree, int refine, Coupling coupling) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::cylinder_model({.radial_patches = 2, .patches_around = 2}));
  ElasticityProblem p =
      problem(model, {.degree = {degree, degree, 1}, .refine = refine}, isotropic(1000, nu));
  for (const char* plane : {"start", "end", "bottom", "top"})
    p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
  p.surface_loads = {pressure_load("pressure", boundary(model, "inner"), 10)};
  const ElasticitySolution solution = solve_elasticity(p, {.coupling = coupling});
  const double k = 10.0 / 3;
  const double at_bore = (1 + nu) / 1000 * k * ((1 - 2 * nu) + 4);
  const FieldValues values = evaluate(solution.field, 0, solution.field.patches[0].low());
  EXPECT_NEAR(values.place.norm(), 1, 1e-12);
  return std::abs(values.displacement.norm() / at_bore - 1);
}

TEST(SolveElasticity, SolvesTheThickCylinder) {
  for (const Coupling coupling : all_couplings)
    EXPECT_LT(cylinder_error(0.3, 4, 2, coupling), 1e-6) << name(coupling);
}

TEST(SolveElasticity, CouplingsAgreeInDisplacementEnergyAndMultipliers) {
  ElasticityProblem p = problem(distorted_box(), {.degree = {3, 2, 2}}, steel);
  const auto& model = p.discretization.model;
  p.supports = {{"clamp", boundary(model, "x_min"), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("shear", boundary(model, "x_max"), {0, 3e6, -5e6})};
  const ElasticitySolution a = solve_elasticity(p, {.coupling = Coupling::elimination});
  const ElasticitySolution b = solve_elasticity(p, {.coupling = Coupling::lagrange});
  double difference = 0;
  for (std::size_t i = 0; i < a.field.displacement.size(); ++i)
    difference = isopatch::larger(
        difference,
        (a.field.displacement[i] - b.field.displacement[i]).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  EXPECT_LT(difference / a.results.max_displacement.value, 1e-9);
  EXPECT_NEAR(a.results.internal_energy / b.results.internal_energy, 1, 1e-9);
  ASSERT_EQ(a.multipliers.size(), b.multipliers.size());
  ASSERT_FALSE(a.multipliers.empty());
  double largest = 0;
  double apart = 0;
  for (std::size_t i = 0; i < a.multipliers.size(); ++i) {
    ASSERT_EQ(a.multipliers[i].second_node, b.multipliers[i].second_node);
    largest = isopatch::larger(largest, a.multipliers[i].force.norm());
    apart = isopatch::larger(apart, (a.multipliers[i].force - b.multipliers[i].force).norm());
  }
  EXPECT_LT(apart / largest, 1e-9);
  EXPECT_EQ(a.size.multipliers, a.size.dofs_uncoupled - a.size.dofs_eliminated);
  EXPECT_LT(b.size.multipliers_free, b.size.multipliers);
}

TEST(Loads, NeedWhatTheyActOn) {
  const geometry::MultiPatch box = distorted_box();
  const Discretization d = discretize(box, {});
  EXPECT_ERROR(total_force("pull", {}, {1, 0, 0}, d), ErrorCode::invalid_argument,
               "'pull': a force needs faces with an area to act on");
  const std::vector<Material> light(d.patches.size(), isotropic(1e9, 0.3));
  EXPECT_ERROR(gravity("weight", {PatchId(1)}, {0, 0, -9.81}, light), ErrorCode::invalid_argument,
               "'weight': patch 1 has no density; gravity and acceleration need one in its material");
  ElasticityProblem p = problem(box, {}, light.front());
  p.supports = {{"clamp", boundary(box, "x_min"), PrescribedDisplacement{}}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  p.surface_loads = {constant_traction("gust", boundary(box, "x_max"), {nan, 0, 0})};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument, "'gust': the load on face");
  p.surface_loads.clear();
  p.volume_loads = {
      {"pull", {PatchId(0)}, [&](const Eigen::Vector3d&) { return Eigen::Vector3d(0, nan, 0); }}};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument,
               "'pull': the force in patch 0 is not finite");
}

TEST(SolveElasticity, RollersPushAlongTheirNormalsOnly) {
  const geometry::NurbsVolume cube;
  Eigen::Matrix3Xd points = cube.control_points();
  points.row(0) += 0.6 * points.row(1);
  ElasticityProblem p = problem(geometry::connect({{geometry::NurbsVolume(cube.knots(), points)}, {}, {}}),
                                {.refine = 1}, steel);
  const auto side = [](geometry::Side s) { return std::vector<geometry::PatchFace>{{PatchId(0), s}}; };
  p.supports = {{"south", side(geometry::Side::south), PlaneSupport{}},
                {"west", side(geometry::Side::west), PlaneSupport{}},
                {"front", side(geometry::Side::front), PlaneSupport{}}};
  p.surface_loads = {constant_traction("push", side(geometry::Side::east), {-2e6, 1e6, 0})};
  const auto reactions = solve_elasticity(p).results.reactions;
  const double size = reactions[1].force.norm();
  EXPECT_GT(size, 1e6);
  EXPECT_NEAR(reactions[0].force[0] / size, 0, 1e-9);
  EXPECT_NEAR(reactions[1].force[1] / reactions[1].force[0], -0.6, 1e-9);
}

// Two patches in a row whose shared corners are `off` away from where they should be, by `direction`.
geometry::MultiPatch imperfect_bar(double off, int direction, bool both_patches) {
  geometry::PatchSet set = geometry::box_model({.size = {0.1, 1, 1}, .patches = {2, 1, 1}});
  for (std::size_t p = both_patches ? 0 : 1; p < 2; ++p) {
    Eigen::Matrix3Xd points = set.patches[p].control_points();
    for (int i = 0; i < 8; ++i)
      if (std::abs(points(0, i) - 0.05) < 1e-9 && points(2, i) == 0) points(direction, i) += off;
    set.patches[p] = geometry::NurbsVolume(set.patches[p].knots(), points);
  }
  return geometry::connect(set);
}

TEST(SolveElasticity, DoesNotLockOnASymmetryPlaneThatIsFlatOnlyToTheTolerance) {
  double energy[2];
  for (const int imperfect : {0, 1}) {
    ElasticityProblem p = problem(imperfect_bar(5e-7 * imperfect, 2, true), {.degree = {2, 2, 2}}, steel);
    const auto& model = p.discretization.model;
    for (const char* plane : {"x_min", "y_min", "z_min"})
      p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
    p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e8, 0, 0})};
    energy[imperfect] = solve_elasticity(p).results.internal_energy;
  }
  EXPECT_NEAR(energy[1] / energy[0], 1, 1e-4);
}

TEST(SolveElasticity, AGradientDoesNotContradictItselfAcrossAGapWithinTheTolerance) {
  ElasticityProblem p = problem(imperfect_bar(1e-7, 0, false), {}, steel);
  PrescribedDisplacement stretched{.value = {-5e-5, 0.0, 0.0}};
  stretched.gradient(0, 0) = 1e-3;
  p.supports = {{"stretched", boundary(p.discretization.model, "z_min"), stretched}};
  const ElasticField field = solve_elasticity(p).field;
  for (int patch = 0; patch < 2; ++patch)
    for (const double share : {0.0, 1.0}) {
      const FieldValues there = evaluate(field, patch, {share, 0.5, 0});
      // The gap of 1e-7 times the gradient is all that the two sides disagree about.
      EXPECT_NEAR(there.displacement[0], -5e-5 + 1e-3 * there.place[0], 1.01e-10);
      EXPECT_NEAR(there.displacement.tail<2>().norm(), 0, 1e-15);
    }
}

TEST(SolveElasticity, NamesTheRigidMotionsLeft) {
  ElasticityProblem p = problem(distorted_box(), {}, steel);
  p.supports = {{"rest", boundary(p.discretization.model, "z_min"), PlaneSupport{}}};
  try {
    solve_elasticity(p);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::free_body);
    EXPECT_THAT(error.what(), HasSubstr("translation along x; translation along y; rotation"));
    EXPECT_THAT(error.what(), HasSubstr("m along z\n"));
  }
}

// Two directions that are left free have no axes of their own; the coordinate axes are the readable ones.
TEST(SolveElasticity, NamesFreeDirectionsByTheCoordinateAxesWhereTheseAre) {
  ElasticityProblem p = problem(distorted_box(), {.refine = 1}, steel);
  p.supports = {{"stop", boundary(p.discretization.model, "x_min"), PrescribedDisplacement{{0.0, {}, {}}}}};
  try {
    solve_elasticity(p);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("translation along y; translation along z; rotation about the axis through"));
    EXPECT_THAT(error.what(), HasSubstr("m along x\n"));
  }
}

// Its edge holds it, by half its thickness: not a motion is left, but such an element is too thin.
TEST(SolveElasticity, TakesAThinSheetForHeldByItsEdge) {
  ElasticityProblem p = problem(geometry::connect(geometry::box_model({.size = {10, 10, 1e-4}})), {}, steel);
  const auto& model = p.discretization.model;
  p.supports = {{"clamp", boundary(model, "x_min"), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e6, 0, 0})};
  try {
    solve_elasticity(p);
  } catch (const Error& error) {
    EXPECT_NE(error.code(), ErrorCode::free_body);
    EXPECT_THAT(error.what(), HasSubstr("100000 times as long as thick"));
  }
}

TEST(SolveElasticity, RefusesSupportsThatContradictEachOther) {
  ElasticityProblem p = problem(distorted_box(), {}, steel);
  const auto& model = p.discretization.model;
  p.supports = {{"clamp", boundary(model, "x_min"), PrescribedDisplacement{}},
                {"lift", boundary(model, "z_max"), PrescribedDisplacement{{0.0, 0.0, 1e-3}}}};
  try {
    solve_elasticity(p);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::conflict);
    EXPECT_THAT(error.what(), HasSubstr("'clamp' and 'lift'"));
  }
}

}  // namespace
}  // namespace isopatch::iga
