#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "geometry/base/larger.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/box.hpp"
#include "geometry/splines/basis.hpp"
#include "iga/assembly/assembly.hpp"
#include "iga/assembly/face_stiffness.hpp"
#include "iga/assembly/interface_stiffness.hpp"
#include "iga/assembly/mortar_constraints.hpp"
#include "iga/assembly/mortar_stiffness.hpp"
#include "iga/estimate/error_estimate.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/spaces/multiplier_space.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;
using geometry::MultiPatch;
using geometry::PatchFace;
using geometry::PatchSet;
using geometry::Side;
using solvers::Method;

// A box of 2 x 1 x 1 and above it so many others, shifted along x.
MultiPatch box_below(int above, double shift = 0) {
  PatchSet set = geometry::box_model({.size = {2, 1, 1}});
  set.boundaries.clear();
  for (int i = 0; i < above; ++i) {
    const PatchSet other =
        geometry::box_model({.size = {2.0 / above, 1, 1}, .origin = {shift + 2.0 * i / above, 0, 1}});
    set.patches.push_back(other.patches.front());
  }
  return geometry::connect(set, {.keep_non_matching = true});
}

// Held below, pulled and sheared above.
ElasticityProblem loaded(const MultiPatch& model, int degree, int refine) {
  ElasticityProblem p = testing::problem(
      model, {.degree = {degree, degree, degree}, .refine = refine, .spread = false}, testing::steel);
  p.supports = {{"ground", {PatchFace{PatchId(0), Side::front}}, {}}};
  for (int i = 1; i < model.patch_count(); ++i)
    p.surface_loads.push_back({"load",
                               {PatchFace{PatchId(i), Side::back}},
                               [](const Eigen::Vector3d& x, const Eigen::Vector3d&) -> Eigen::Vector3d {
                                 return {1e6 * x.x(), 2e6, 3e6};
                               }});
  return p;
}

ElasticitySolution solved(const ElasticityProblem& p, Method method,
                          Coupling coupling = Coupling::elimination,
                          MortarSide side = MortarSide::automatic) {
  ElasticityOptions options{
      .coupling = coupling, .non_matching = NonMatchingCoupling::mortar, .mortar_side = side};
  options.solver.method = method;
  options.solver.tolerance = 1e-11;
  return solve_elasticity(p, options);
}

double difference(const ElasticField& a, const ElasticField& b) {
  double apart = 0, size = 0;
  for (std::size_t p = 0; p < a.displacement.size(); ++p) {
    apart = isopatch::larger(
        apart, (a.displacement[p] - b.displacement[p]).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    size = isopatch::larger(size, a.displacement[p].cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  return apart / size;
}

TEST(MultiplierSpace, HasOneDegreeLessAtBothEndsAndAddsUpToOne) {
  for (int degree = 1; degree <= 5; ++degree)
    for (const int elements : {1, 2, 3, 7}) {
      const KnotVector knots = KnotVector::uniform(degree, elements);
      const Eigen::MatrixXd coefficients = multiplier_coefficients(knots, {true, true});
      SCOPED_TRACE(::testing::PrintToString(std::pair(degree, elements)));
      EXPECT_EQ(coefficients.cols(), std::max(1, knots.size() - 2));
      EXPECT_LT((coefficients.rowwise().sum() - Eigen::VectorXd::Ones(knots.size()))
                    .cwiseAbs()
                    .maxCoeff<Eigen::PropagateNaN>(),
                1e-11);
      if (knots.size() < 3) continue;
      for (const double t : {0.3 / elements, 1 - 0.3 / elements}) {
        const geometry::BasisValues b = geometry::basis(knots, t, degree);
        const Eigen::RowVectorXd highest =
            b.values.row(degree) * coefficients.middleRows(b.first, degree + 1);
        EXPECT_LT(highest.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
                  1e-10 * b.values.row(degree).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
      }
    }
}

TEST(MortarFaces, AreThoseThatOthersCoverAllOver) {
  const MultiPatch model = box_below(2);
  const auto roles = [](const MultiPatch& m, std::vector<Material> materials, MortarSide side) {
    return mortar_faces(discretize(m, {.degree = {2, 2, 2}}), materials, side);
  };
  const std::vector<Material> same(3, testing::steel);
  const std::vector<MortarFace> finer = roles(model, same, MortarSide::automatic);
  ASSERT_EQ(finer.size(), 2u);
  EXPECT_EQ(finer[0].slave.patch, PatchId(1));
  EXPECT_EQ(finer[0].masters, std::vector{(PatchFace{PatchId(0), Side::back})});
  EXPECT_EQ(finer[0].reason, "the finer side");
  const std::vector<MortarFace> other = roles(model, same, MortarSide::other);
  ASSERT_EQ(other.size(), 1u);
  EXPECT_EQ(other[0].masters.size(), 2u);
  std::vector<Material> softer_below = same;
  softer_below[0] = isotropic(70e9, 0.3);
  EXPECT_EQ(roles(model, softer_below, MortarSide::automatic).front().reason, "the softer side");
  // The upper ones hang over the lower one's end, so that no side covers the other.
  EXPECT_ERROR(roles(box_below(2, 0.5), same, MortarSide::automatic), ErrorCode::unsupported,
               "parts stay free");
}

TEST(MortarFaces, OfTheHigherDegreeFollow) {
  const MultiPatch model = geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  for (const int higher : {0, 1}) {
    DiscretizationOptions options{.degree = {2, 2, 2}, .spread = false};
    options.patches = {{.patches = {higher}, .degree = {3, 3, 3}}};
    const std::vector<MortarFace> faces =
        mortar_faces(discretize(model, options), std::vector<Material>(2, testing::steel));
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(faces[0].slave.patch, PatchId(higher));
    EXPECT_EQ(faces[0].reason, "the finer side");
  }
}

// The block of all nodes on two sides that share an edge.
TEST(FaceStiffness, IsABlockOfThePatchsStiffness) {
  const ElasticityProblem p =
      testing::problem(geometry::connect(geometry::box_model({.distortion = 0.2, .seed = 5})),
                       {.degree = {2, 3, 2}, .refine = 1}, testing::steel);
  const std::vector<PatchSpace> spaces = isoparametric_spaces(p.discretization);
  std::vector<int> all(static_cast<std::size_t>(spaces[0].size()));
  std::iota(all.begin(), all.end(), 0);
  const RowNumbering numbering{all, spaces[0].size()};
  const solvers::SymmetricBlockMatrix whole =
      assemble_stiffness(spaces, whole_patches(spaces), p.materials, numbering);
  const std::vector<Side> sides = {Side::west, Side::front};
  solvers::SymmetricBlockMatrix part = whole;
  std::fill(part.values.begin(), part.values.end(), 0.0);
  face_stiffness(spaces[0], sides, 0, testing::steel).add_to(part, numbering);
  EXPECT_EQ(part.blocks(), whole.blocks());
  std::set<int> on_sides;
  for (const Side side : sides)
    for (const int node : geometry::face_control_points(spaces[0].sizes(), side)) on_sides.insert(node);
  double largest = 0, difference = 0;
  for (int row = 0; row < whole.block_rows(); ++row)
    for (std::int64_t k = whole.row_start[static_cast<std::size_t>(row)];
         k < whole.row_start[static_cast<std::size_t>(row) + 1]; ++k) {
      const bool is_here =
          on_sides.contains(row) && on_sides.contains(whole.columns[static_cast<std::size_t>(k)]);
      for (std::size_t i = 0; i < 9; ++i) {
        const std::size_t at = 9 * static_cast<std::size_t>(k) + i;
        largest = isopatch::larger(largest, std::abs(whole.values[at]));
        difference =
            isopatch::larger(difference, std::abs(part.values[at] - (is_here ? whole.values[at] : 0.0)));
      }
    }
  EXPECT_LT(difference, 1e-12 * largest);
}

TEST(Mortar, DirectAndIterativeSolversAndBothSidesAgree) {
  const ElasticityProblem p = loaded(box_below(2), 2, 1);
  const ElasticitySolution direct = solved(p, Method::mumps);
  EXPECT_EQ(direct.mortar.size(), 2u);
  EXPECT_LT(difference(direct.field, solved(p, Method::umfpack).field), 1e-9);
  EXPECT_LT(difference(direct.field, solved(p, Method::mumps, Coupling::lagrange).field), 1e-9);
  const ElasticitySolution iterated = solved(p, Method::minres);
  EXPECT_LT(difference(direct.field, iterated.field), 1e-7);
  const ElasticitySolution projected = solved(p, Method::cg);
  EXPECT_LT(difference(direct.field, projected.field), 1e-8);
  // Both take 16; with projections that move nodes of one side alone it was 32.
  EXPECT_LE(projected.solver.iterations, 20);
  EXPECT_LE(iterated.solver.iterations, 20);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_LT((direct.mortar[f].force - projected.mortar[f].force).norm(),
              1e-6 * direct.mortar[f].force.norm());
    EXPECT_LT((direct.mortar[f].force - iterated.mortar[f].force).norm(),
              1e-6 * direct.mortar[f].force.norm());
  }
  // The discretization error is some percent.
  const ElasticitySolution other = solved(p, Method::mumps, Coupling::elimination, MortarSide::other);
  EXPECT_GT(difference(direct.field, other.field), 1e-9);
  EXPECT_LT(difference(direct.field, other.field), 0.05);
}

TEST(Mortar, ForcesAndEnergiesBalance) {
  const ElasticityProblem p = loaded(box_below(3), 2, 1);
  for (const MortarSide side : {MortarSide::automatic, MortarSide::other}) {
    const ElasticitySolution s = solved(p, Method::mumps, Coupling::elimination, side);
    Eigen::Vector3d between = Eigen::Vector3d::Zero();
    for (const MortarTie& tie : s.mortar) between += (side == MortarSide::automatic ? -1 : 1) * tie.force;
    const Eigen::Vector3d load(1e6 * 2, 2e6 * 2, 3e6 * 2);
    EXPECT_LT((between - load).norm(), 1e-9 * load.norm());
    EXPECT_LT((s.results.reactions[0].force + load).norm(), 1e-9 * load.norm());
    EXPECT_NEAR(s.results.internal_energy / s.results.external_work, 1, 1e-10);
    EXPECT_LT(std::abs(s.results.interface_energy), 1e-12 * s.results.internal_energy);
  }
}

// Held and moved at nodes that are tied, so that constraints have right sides.
TEST(Mortar, PrescribedDisplacementsGoThroughTheInterface) {
  const MultiPatch model = box_below(2);
  ElasticityProblem p =
      testing::problem(model, {.degree = {2, 2, 2}, .refine = 1, .spread = false}, testing::steel);
  Eigen::Matrix3d gradient;
  gradient << 1e-3, 4e-4, -2e-4, 3e-4, -5e-4, 1e-4, -1e-4, 6e-4, 8e-4;
  std::vector<PatchFace> all;
  for (const PatchFace& face : model.boundary_faces()) all.push_back(face);
  p.supports = {{"all around", all, PrescribedDisplacement{{1e-3, 2e-3, -1e-3}, gradient}}};
  for (const Method method : {Method::mumps, Method::umfpack, Method::cg, Method::minres}) {
    const ElasticitySolution s = solved(p, method);
    double error = 0;
    for (std::size_t i = 0; i < s.field.patches.size(); ++i) {
      const Eigen::Matrix3Xd exact =
          (gradient * s.field.patches[i].control_points()).colwise() + Eigen::Vector3d(1e-3, 2e-3, -1e-3);
      error = isopatch::larger(error,
                               (s.field.displacement[i] - exact).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    }
    EXPECT_LT(error, 1e-9 * 1e-3) << solvers::name(method);
  }
}

// Jumps of a coarse slave cost nothing, so the estimate must not count what Nitsche's penalty would.
TEST(Mortar, ErrorsAreEstimatedAsLargeAsWithNitsche) {
  const ElasticityProblem p = loaded(box_below(2), 2, 1);
  const double nitsche = estimate_error(p, solve_elasticity(p).field).relative;
  for (const MortarSide side : {MortarSide::automatic, MortarSide::other}) {
    const ElasticitySolution s = solved(p, Method::mumps, Coupling::elimination, side);
    const double mortar =
        estimate_error(p, s.field, {}, {.non_matching = NonMatchingCoupling::mortar}).relative;
    EXPECT_GT(mortar, 0.7 * nitsche);
    EXPECT_LT(mortar, 1.5 * nitsche);
  }
}

// Slave faces of one patch that meet at an edge: one of two by two boxes of higher degree.
ElasticityProblem boxes_around_one_of_higher_degree(int refine) {
  const MultiPatch model = geometry::connect(geometry::box_model({.size = {2, 2, 1}, .patches = {2, 2, 1}}),
                                             {.keep_non_matching = true});
  DiscretizationOptions options{.degree = {2, 2, 2}, .refine = refine, .spread = false};
  options.patches = {{.patches = {0}, .degree = {3, 3, 3}}};
  ElasticityProblem p = testing::problem(model, options, testing::steel);
  EXPECT_EQ(p.discretization.model.non_matching().size(), 2u);
  p.supports = {{"left", {PatchFace{PatchId(2), Side::west}}, PrescribedDisplacement{}}};
  p.surface_loads = {{"pull",
                      {PatchFace{PatchId(1), Side::east}},
                      [](const Eigen::Vector3d&, const Eigen::Vector3d&) -> Eigen::Vector3d {
                        return {1e6, 2e6, 3e6};
                      }}};
  return p;
}

TEST(Mortar, SlaveFacesOfOnePatchShareTheirEdge) {
  std::vector<double> apart;
  for (const int refine : {1, 2}) {
    const ElasticityProblem p = boxes_around_one_of_higher_degree(refine);
    const ElasticitySolution direct = solved(p, Method::mumps);
    EXPECT_LT(difference(direct.field, solved(p, Method::cg).field), 1e-7);
    apart.push_back(direct.results.external_work / solve_elasticity(p).results.external_work - 1);
  }
  EXPECT_LT(std::abs(apart[0]), 0.04);
  EXPECT_LT(std::abs(apart[1]), 0.7 * std::abs(apart[0]));
}

double energy(const NodeBlocks& springs, const Eigen::Matrix3Xd& displacement) {
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, displacement.cols());
  springs.add_forces(displacement, forces);
  return displacement.cwiseProduct(forces).sum();
}

// Displacements that satisfy the constraints jump where edges are shared, and no spring may see it.
TEST(MortarStiffness, IsOfWhatTheConstraintsForbidAlone) {
  const ElasticityProblem p = loaded(box_below(3), 2, 1);
  const CoupledProblem coupled = coupled_problem(p, {.non_matching = NonMatchingCoupling::mortar});
  const geometry::MultiPatch& model = p.discretization.model;
  const double same_point = model.tolerance().same_point * model.size();
  const NodeBlocks springs = mortar_stiffness(coupled.mortar.ties, coupled.spaces, p.materials, same_point);
  const NodeBlocks penalties = interface_stiffness(coupled_faces(p.discretization, p.materials),
                                                   coupled.spaces, p.materials, same_point);
  const ElasticField field = solved(p, Method::mumps).field;
  const std::vector<int> first = first_nodes(coupled.spaces);
  Eigen::Matrix3Xd solution(3, first.back());
  for (std::size_t patch = 0; patch < field.displacement.size(); ++patch)
    solution.middleCols(first[patch], first[patch + 1] - first[patch]) = field.displacement[patch];
  Eigen::Matrix3Xd apart = Eigen::Matrix3Xd::Zero(3, first.back());
  apart.rightCols(first.back() - first[1]).setConstant(solution.cwiseAbs().mean());
  EXPECT_GT(energy(springs, apart), energy(penalties, apart));
  EXPECT_LT(std::abs(energy(springs, solution)), 1e-15 * energy(springs, apart));
  EXPECT_GT(std::abs(energy(penalties, solution)), 1e-8 * energy(penalties, apart));
}

// The middle one of three boxes with one linear element shares both its edges.
TEST(Mortar, FacesWithoutInnerNodes) {
  const ElasticityProblem p = loaded(box_below(3), 1, 0);
  const ElasticitySolution s = solved(p, Method::mumps);
  EXPECT_LT(difference(s.field, solved(p, Method::cg).field), 1e-8);
  EXPECT_NEAR(s.results.internal_energy / s.results.external_work, 1, 1e-10);
}

// One edge of the face gives way to the corner.
TEST(Mortar, CornersThatSupportsHoldFollowNothing) {
  ElasticityProblem p = loaded(box_below(2), 2, 1);
  p.supports.push_back({"pin", {}, PrescribedDisplacement{}});
  p.supports.back().corners = {{PatchId(1), {false, false, false}}, {PatchId(0), {false, false, true}}};
  const ElasticitySolution direct = solved(p, Method::mumps);
  EXPECT_LT(difference(direct.field, solved(p, Method::cg).field), 1e-7);
  EXPECT_EQ(direct.field.displacement[1].col(0).norm(), 0);
}

// Springs that carry half of the load store energy, which is none of jumps.
TEST(Mortar, ErrorsBesideElasticSupportsAreThoseOfNitsche) {
  ElasticityProblem p = loaded(box_below(2), 2, 1);
  p.supports = {{"bed", {PatchFace{PatchId(0), Side::front}}, ElasticSupport{5e10, 5e10}}};
  const double nitsche = estimate_error(p, solve_elasticity(p).field).relative;
  const double mortar =
      estimate_error(p, solved(p, Method::mumps).field, {}, {.non_matching = NonMatchingCoupling::mortar})
          .relative;
  EXPECT_GT(mortar, 0.7 * nitsche);
  EXPECT_LT(mortar, 1.3 * nitsche);
}

TEST(Mortar, TakesNoCholeskyFactors) {
  const ElasticityProblem p = loaded(box_below(2), 1, 1);
  EXPECT_ERROR(solved(p, Method::cholmod), ErrorCode::invalid_argument, "non_matching = \"nitsche\"");
  EXPECT_ERROR(solved(p, Method::cg, Coupling::lagrange), ErrorCode::invalid_argument,
               "coupling 'elimination'");
}

}  // namespace
}  // namespace isopatch::iga
