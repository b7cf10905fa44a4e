// Cylindrical, elastic and point supports, and bodies that nothing holds.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/link.hpp"
#include "iga/coupling/free_motions.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/problem/bearing_load.hpp"
#include "iga/problem/face_axis.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Vector3d;
using testing::boundary;
using testing::problem;
using testing::steel;

const Coupling couplings[] = {Coupling::elimination, Coupling::lagrange};

// All ways to solve, of both couplings.
std::vector<ElasticityOptions> all_ways() {
  std::vector<ElasticityOptions> result;
  for (const auto method : {solvers::Method::cholmod, solvers::Method::cg})
    result.push_back({.solver = {.method = method, .tolerance = 1e-12}});
  result.push_back({.solver = {.method = solvers::Method::cg, .tolerance = 1e-12}});
  result.back().solver.form = solvers::Operator::assembled;
  for (const auto method : {solvers::Method::mumps, solvers::Method::minres})
    result.push_back({.coupling = Coupling::lagrange, .solver = {.method = method, .tolerance = 1e-11}});
  return result;
}

geometry::MultiPatch ring(double degrees) {
  return geometry::connect(geometry::cylinder_model({.angle = Angle::degrees(degrees), .radial_patches = 2}));
}

Vector3d sum_of_reactions(const ElasticityResults& results) {
  Vector3d sum = Vector3d::Zero();
  for (const Reaction& reaction : results.reactions) sum += reaction.force;
  return sum;
}

void expect_balance(const ElasticityResults& results, double within) {
  EXPECT_LT((sum_of_reactions(results) + results.total_load).norm(), within * results.load_size);
  EXPECT_NEAR(results.internal_energy + results.support_energy, results.external_work,
              within * results.external_work);
}

// A bar on springs at both ends, pulled by a body force: a closed form in one dimension (nu = 0).
TEST(ElasticSupport, OfABarOnSpringsIsExactByAllWays) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, isotropic(1000, 0));
  const double stiffness = 700, other = 300, force = 50;
  p.supports = {{"left", boundary(model, "x_min"), ElasticSupport{stiffness, 0}},
                {"right", boundary(model, "x_max"), ElasticSupport{other, 0}},
                {"y", boundary(model, "y_min"), PlaneSupport{}},
                {"z", boundary(model, "z_min"), PlaneSupport{}}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {force, 0, 0})};
  // Springs k1 and E / L in series, k2 beside them.
  const double series = 1 / (1 / stiffness + 1 / 1000.0);
  const double end = force / (series + other), start = series * end / stiffness;
  for (const ElasticityOptions& options : all_ways()) {
    SCOPED_TRACE(solvers::name(options.solver.method));
    const ElasticitySolution s = solve_elasticity(p, options);
    for (int patch = 0; patch < p.discretization.patch_count(); ++patch) {
      const FieldValues at = evaluate(s.field, patch, {0.3, 0.6, 0.2});
      EXPECT_NEAR(at.displacement[0], start + (end - start) * at.place[0], 1e-9 * end);
    }
    EXPECT_NEAR(s.results.reactions[0].force[0], -stiffness * start, 1e-8 * force);
    EXPECT_NEAR(s.results.reactions[1].force[0], -other * end, 1e-8 * force);
    expect_balance(s.results, 1e-8);
    EXPECT_NEAR(s.results.support_energy, 0.5 * (stiffness * start * start + other * end * end), 1e-9);
  }
}

TEST(ElasticSupport, TakesABodyThatNothingElseHolds) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, steel);
  p.supports = {{"bed", boundary(model, "z_min"), ElasticSupport{2e9, 5e8}}};
  p.surface_loads = {constant_traction("push", boundary(model, "x_max"), {3e6, -1e6, 2e6})};
  const ElasticitySolution direct = solve_elasticity(p);
  expect_balance(direct.results, 1e-9);
  for (const ElasticityOptions& options : all_ways()) {
    const ElasticitySolution s = solve_elasticity(p, options);
    EXPECT_NEAR(s.results.support_energy / direct.results.support_energy, 1, 1e-8);
    EXPECT_NEAR(s.results.internal_energy / direct.results.internal_energy, 1, 1e-8);
  }
  // Moments about the origin balance as well: the push acts at (1, 1/2, 1/2).
  const Vector3d moment =
      direct.results.reactions[0].moment + Vector3d(1, 0.5, 0.5).cross(Vector3d(3e6, -1e6, 2e6));
  EXPECT_LT(moment.norm(), 1e-9 * 3e6);
}

TEST(ElasticSupport, OfNormalSpringsAloneLeavesTheFaceFreeToSlide) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, steel);
  p.supports = {{"bed", boundary(model, "z_min"), ElasticSupport{2e9, 0}}};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::free_body, "translation along x");
  p.supports = {{"bed", boundary(model, "z_min"), PrescribedDisplacement{}},
                {"foot", boundary(model, "z_max"), ElasticSupport{-1, 0}}};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument, "not negative");
}

// Springs so stiff that they are a clamp: the multigrid must not mind.
TEST(ElasticSupport, ManyTimesStifferThanThePartIsAClampAndConverges) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}, .refine = 1}, steel);
  p.surface_loads = {constant_traction("push", boundary(model, "z_max"), {3e6, -1e6, 2e6})};
  p.supports = {{"bed", boundary(model, "z_min"), PrescribedDisplacement{}}};
  const double clamped = solve_elasticity(p).results.internal_energy;
  p.supports[0].condition = ElasticSupport{1e6 * 210e9, 1e6 * 210e9};
  const ElasticitySolution s =
      solve_elasticity(p, {.solver = {.method = solvers::Method::cg, .tolerance = 1e-11}});
  EXPECT_NEAR(s.results.internal_energy / clamped, 1, 1e-4);  // a millionth of the size gives way
  EXPECT_LE(s.solver.iterations, 40);
}

TEST(CylindricalSupport, LetsThePartTurnAboutItsAxisWithoutStress) {
  const geometry::MultiPatch model = ring(360);
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}, .refine = 1}, steel);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  turn(0, 1) = -1e-3;
  turn(1, 0) = 1e-3;
  PrescribedDisplacement turned;
  turned.gradient = turn;
  p.supports = {{"pin", boundary(model, "inner"), CylindricalSupport{.axial = true}},
                {"outer", boundary(model, "outer"), turned}};
  for (const Coupling coupling : couplings) {
    const ElasticitySolution s = solve_elasticity(p, {.coupling = coupling});
    EXPECT_LT(s.results.max_von_mises.value, 1e-8 * 210e9 * 1e-3);
    EXPECT_NEAR(s.results.max_displacement.value, 2e-3, 1e-12);
  }
}

// Twisted by a shear on the outer face and held along the circumference inside: u_t = c r + d / r.
TEST(CylindricalSupport, HeldAgainstTurningTakesATwistAsTheClosedForm) {
  const geometry::MultiPatch model = ring(360);
  for (const Coupling coupling : couplings) {
    ElasticityProblem p = problem(model, {.degree = {3, 3, 3}, .refine = 2}, isotropic(1000, 0.3));
    p.supports = {{"shaft", boundary(model, "inner"),
                   CylindricalSupport{.radial = false, .tangential = true, .axial = true}},
                  {"bottom", boundary(model, "bottom"), PlaneSupport{}},
                  {"top", boundary(model, "top"), PlaneSupport{}}};
    p.supports.push_back({"free", {}, FreeBodySupport{}});
    const double shear = 7;
    p.surface_loads = {{"twist", boundary(model, "outer"), [=](const Vector3d&, const Vector3d& n) {
                          return Vector3d(-shear * n[1], shear * n[0], 0);
                        }}};
    const ElasticitySolution s = solve_elasticity(p, {.coupling = coupling});
    // tau = shear (b / r)^2 with b = 2, and tau = G r d(u / r)/dr: u = shear b^2 / (2 G) (r / a^2 - 1 / r).
    const double g = 1000 / 2.6;
    const auto exact = [&](double r) { return shear * 4 / (2 * g) * (r - 1 / r); };
    for (int patch = 0; patch < p.discretization.patch_count(); ++patch) {
      const FieldValues at = evaluate(s.field, patch, {0.4, 0.3, 0.6});
      const double r = at.place.head<2>().norm();
      const double along = (at.place[0] * at.displacement[1] - at.place[1] * at.displacement[0]) / r;
      // The springs give way by 4e-4 of the largest, and between their points the face does as much again
      // with 16 elements around.
      EXPECT_NEAR(along, exact(r), 1e-3 * exact(2));
    }
    const double moment = shear * 2 * 2 * std::numbers::pi * 2 * 0.5;  // shear radius area
    EXPECT_NEAR(s.results.reactions[0].moment[2], -moment, 1e-9 * moment);
  }
}

TEST(CylindricalSupport, RefusesAnAxisThroughItsFaces) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, steel);
  p.supports = {{"pin", boundary(model, "z_min"), CylindricalSupport{}}};
  EXPECT_ERROR(support_frames(p, global_nodes(p.discretization)), ErrorCode::invalid_argument,
               "lies on the axis");
}

TEST(FaceAxis, IsThatOfABore) {
  const geometry::MultiPatch model = geometry::connect(geometry::link_model({}));
  const FaceAxis axis = face_axis(model, boundary(model, "bore_right"));
  EXPECT_LT((axis.point - Vector3d(100, 0, 6)).norm(), 1e-10);
  EXPECT_EQ(axis.direction, Vector3d::UnitZ());
  EXPECT_LT(axis.off, 1e-10);
  EXPECT_LT(axis.tilt, 1e-10);
  const FaceAxis of_plane = face_axis(model, boundary(model, "top"));
  EXPECT_FALSE(of_plane.off < 1);
}

TEST(FreeBodySupport, HoldsBalancedLoadsWithoutReactions) {
  const geometry::MultiPatch model = testing::distorted_box();
  for (const ElasticityOptions& options : all_ways()) {
    ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, isotropic(1000, 0.25));
    p.supports = {{"nothing", {}, FreeBodySupport{}}};
    p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {5, 0, 0}),
                       constant_traction("pull back", boundary(model, "x_min"), {-5, 0, 0})};
    const ElasticitySolution s = solve_elasticity(p, options);
    const Eigen::Matrix3d uniform = Vector3d(5, 0, 0).asDiagonal();
    for (int patch = 0; patch < p.discretization.patch_count(); ++patch)
      EXPECT_LT((evaluate(s.field, patch, {0.3, 0.6, 0.2}).stress - uniform).norm(), 1e-7);
    EXPECT_LT(s.results.reactions[0].force.norm(), 1e-9 * s.results.load_size);
    EXPECT_NEAR(s.results.internal_energy, 0.5 * 25 / 1000, 1e-9);
  }
}

TEST(FreeBodySupport, ReportsTheImbalance) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, steel);
  p.supports = {{"nothing", {}, FreeBodySupport{}}};
  p.surface_loads = {constant_traction("push", boundary(model, "x_max"), {3, -2, 1})};
  const ElasticitySolution s = solve_elasticity(p);
  EXPECT_LT((s.results.reactions[0].force - Vector3d(-3, 2, -1)).norm(), 1e-9);
  EXPECT_LT((s.results.reactions[0].moment + Vector3d(1, 0.5, 0.5).cross(Vector3d(3, -2, 1))).norm(), 1e-9);
}

TEST(FreeBodySupport, TakesOnlyWhatOthersLeave) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, steel);
  const GlobalNodes global = global_nodes(p.discretization);
  const auto fixed_by = [&](int support) {
    int count = 0;
    for (const SupportFrame& frame : support_frames(p, global))
      for (int k = frame.free; k < 3; ++k) count += frame.support[static_cast<std::size_t>(k)] == support;
    return count;
  };
  p.supports = {{"nothing", {}, FreeBodySupport{}}};
  EXPECT_EQ(fixed_by(0), 6);
  p.supports = {{"rest", {}, FreeBodySupport{}}, {"plane", boundary(model, "z_min"), PlaneSupport{}}};
  EXPECT_EQ(fixed_by(0), 3);
  EXPECT_TRUE(free_motions(p, global, support_frames(p, global)).empty());
  p.supports[1].condition = ElasticSupport{1, 1};
  EXPECT_EQ(fixed_by(0), 0);
}

TEST(Temperature, OfAFreeBodyCausesNoStressAndOfAHeldOneItsClosedForm) {
  const geometry::MultiPatch model = testing::distorted_box();
  Material warm = isotropic(1000, 0.25);
  warm.expansion = 1e-3;
  std::vector<PatchId> all;
  for (int i = 0; i < model.patch_count(); ++i) all.emplace_back(i);
  for (const ElasticityOptions& options : all_ways()) {
    ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, warm);
    p.supports = {{"nothing", {}, FreeBodySupport{}}};
    p.temperatures = {{"sun", all, {20, {0, 0, 0}}}};
    const ElasticitySolution s = solve_elasticity(p, options);
    EXPECT_LT(s.results.max_von_mises.value, 1e-6 * 1000 * 0.02);
    EXPECT_NEAR(evaluate(s.field, 0, {0.3, 0.6, 0.2}).strain(1, 1), 0.02, 1e-9);
    EXPECT_LT(s.results.internal_energy, 1e-9);
    p.supports = {{"plane", boundary(model, "x_min"), PlaneSupport{}},
                  {"other", boundary(model, "x_max"), PlaneSupport{}},
                  {"rest", {}, FreeBodySupport{}}};
    const ElasticitySolution held = solve_elasticity(p, options);
    const Eigen::Matrix3d stress = evaluate(held.field, 0, {0.3, 0.6, 0.2}).stress;
    EXPECT_LT((stress - Eigen::Matrix3d(Vector3d(-20, 0, 0).asDiagonal())).norm(), 1e-7);
    EXPECT_NEAR(held.results.reactions[0].force[0], 20, 1e-7);
    EXPECT_NEAR(held.results.internal_energy, 0.5 * 20 * 0.02, 1e-9);
    EXPECT_NEAR(held.results.internal_energy, held.results.external_work + held.results.thermal_work, 1e-9);
  }
  ElasticityProblem cold = problem(model, {.degree = {2, 2, 2}}, steel);
  cold.supports = {{"nothing", {}, FreeBodySupport{}}};
  cold.temperatures = {{"sun", all, {20, {0, 0, 0}}}};
  EXPECT_ERROR(solve_elasticity(cold), ErrorCode::invalid_argument, "no thermal expansion");
}

TEST(CornerSupport, HoldsAPointInThePlaneOfARoller) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.patches = {2, 1, 1}}));
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}}, isotropic(10, 0.25));
  const PrescribedDisplacement pinned{.value = {std::nullopt, 0.0, 0.0}};
  const PrescribedDisplacement guided{.value = {std::nullopt, 0.0, std::nullopt}};
  p.supports = {{"plane", boundary(model, "x_min"), PlaneSupport{}},
                {"pin", {}, pinned, {}, {{PatchId(0), {false, false, false}}}},
                {"guide", {}, guided, {}, {{PatchId(0), {false, false, true}}}}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1, 0, 0})};
  for (const Coupling coupling : couplings) {
    const ElasticitySolution s = solve_elasticity(p, {.coupling = coupling});
    EXPECT_NEAR(s.results.internal_energy, 0.05, 1e-12);
    EXPECT_LT(s.results.reactions[1].force.norm(), 1e-12);
  }
  p.supports[1].corners[0].patch = PatchId(9);
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument, "no patch 9");
  p.supports[1] = {"pin", {}, PlaneSupport{}, {}, {{PatchId(0)}}};
  EXPECT_ERROR(solve_elasticity(p), ErrorCode::invalid_argument, "needs faces");
}

}  // namespace
}  // namespace isopatch::iga
