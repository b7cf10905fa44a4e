#include "iga/estimate/error_estimate.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/box.hpp"
#include "geometry/models/bracket.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/splines/refine.hpp"
#include "iga/estimate/element_errors.hpp"
#include "iga/estimate/raised_problem.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;
using testing::problem;

// Clamped at one end, pushed aside at the other, of two materials.
ElasticityProblem bent_box(int degree, int refine) {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p =
      problem(model, {.degree = {degree, degree, degree}, .refine = refine}, testing::steel);
  p.materials[2] = p.materials[5] = isotropic(70e9, 0.33);
  p.supports = {{"end", boundary(model, "x_min"), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("push", boundary(model, "x_max"), {1e6, 2e6, 0})};
  p.volume_loads = {
      {"weight", {PatchId(1)}, [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, 1e6); }}};
  return p;
}

double sum_of_elements(const ErrorEstimate& estimate) {
  double sum = 0;
  for (const ElementErrors& of_patch : estimate.elements) sum += of_patch.energy.sum();
  return sum;
}

// What is left at most of the change in the raised space when iterations end: `enough` of its energy for each
// of a few more.
constexpr double unfinished = 0.1;

TEST(ErrorEstimate, IsTheEnergyThatOneDegreeMoreAdds) {
  for (const int degree : {2, 3}) {
    const ElasticityProblem given = bent_box(degree, 1);
    const ElasticitySolution solution = solve_elasticity(given);
    const double gain = solve_elasticity(with_degree_raised(given)).results.internal_energy -
                        solution.results.internal_energy;
    const ErrorEstimate estimate = estimate_error(given, solution.field);
    EXPECT_LT(estimate.energy, (1 + 1e-6) * gain);
    EXPECT_GT(estimate.energy, (1 - unfinished) * gain);
    const double whole = solution.results.internal_energy + estimate.energy;
    EXPECT_NEAR(estimate.relative, std::sqrt(estimate.energy / whole), 1e-6 * estimate.relative);
  }
}

// The second step adds little here, and the third a lot.
TEST(ErrorEstimate, GoesOnWhereInterfacesDoNotMatch) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  ElasticityProblem p = problem(model,
                                {.degree = {2, 2, 2},
                                 .refine = 1,
                                 .patches = {{.patches = {1}, .elements_per_direction = {3, 3, 3}}},
                                 .spread = false},
                                testing::steel);
  ASSERT_EQ(p.discretization.model.non_matching().size(), 1u);
  for (const char* plane : {"x_min", "y_min", "z_min"})
    p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {10e6, 4e6, 0})};
  p.volume_loads = {{"weight", {PatchId(0), PatchId(1)}, [](const Eigen::Vector3d&) {
                       return Eigen::Vector3d(3e6, 10e6, -5e6);
                     }}};
  const ElasticitySolution solution = solve_elasticity(p);
  const double gain =
      solve_elasticity(with_degree_raised(p)).results.external_work - solution.results.external_work;
  EXPECT_GT(estimate_error(p, solution.field).energy, (1 - unfinished) * gain);
}

TEST(ErrorEstimate, IsTheSumOverElementsOfAllPatches) {
  const ElasticityProblem given = bent_box(2, 0);
  const ErrorEstimate estimate = estimate_error(given, solve_elasticity(given).field);
  ASSERT_EQ(estimate.elements.size(), 8u);
  // Gauss points of both are the same, and so many that products of raised functions are exact but for the
  // map.
  EXPECT_NEAR(sum_of_elements(estimate), estimate.energy, 1e-9 * estimate.energy);
  for (const ElementErrors& of_patch : estimate.elements) {
    EXPECT_GT(of_patch.energy.minCoeff<Eigen::PropagateNaN>(), 0);
    EXPECT_GT(of_patch.stress.minCoeff<Eigen::PropagateNaN>(), 0);
  }
}

TEST(ErrorEstimate, DoesNotDependOnTheCoupling) {
  const ElasticityProblem given = bent_box(2, 0);
  const double eliminated = estimate_error(given, solve_elasticity(given).field).energy;
  const double tied =
      estimate_error(given, solve_elasticity(given, {.coupling = Coupling::lagrange}).field).energy;
  EXPECT_NEAR(tied, eliminated, 1e-7 * eliminated);
}

// One set-up serves all, and what adds up in the loads adds up in what is estimated.
TEST(ErrorEstimate, OfCasesIsThatOfTheirOwnProblems) {
  ElasticityProblem given = bent_box(2, 0);
  given.volume_loads.clear();
  given.point_loads = {{"finger", {0, 0, 1e6}, {{PatchId(0), {0.3, 0.4, 1}, 1}}}};
  const LoadCases cases = {{{"first", {given.surface_loads.front().name}, {}}, {"second", {"finger"}, {}}},
                           {{"sum", {2, -1}}}};
  const std::vector<ElasticitySolution> solutions = solve_cases(given, cases);
  const ErrorEstimator estimator(given);
  std::vector<Eigen::Matrix3Xd> loads;
  for (std::size_t i = 0; i < 2; ++i) {
    const ElasticityProblem own = of_case(given, cases.cases[i]);
    loads.push_back(estimator.loads(own));
    const double alone = estimate_error(own, solve_elasticity(own).field).energy;
    EXPECT_NEAR(estimator.estimate(loads[i], solutions[i].field).energy, alone, 1e-7 * alone);
  }
  ElasticityProblem sum = given;
  for (SurfaceLoad& load : sum.surface_loads)
    load.traction = [traction = load.traction](const Eigen::Vector3d& x, const Eigen::Vector3d& n) {
      return Eigen::Vector3d(2 * traction(x, n));
    };
  sum.point_loads[0].force *= -1;
  const double alone = estimate_error(sum, solve_elasticity(sum).field).energy;
  loads.push_back(2 * loads[0] - loads[1]);
  EXPECT_NEAR(estimator.estimate(loads[2], solutions[2].field).energy, alone, 1e-7 * alone);
  // All at once, each with its own number of iterations and its own places.
  const std::vector<PatchPlace> place = {{0, geometry::Parameter<3>(0.3, 0.4, 0.5)}};
  const std::vector<ErrorEstimate> together = estimator.estimates({{loads[0], solutions[0].field, place},
                                                                   {loads[1], solutions[1].field},
                                                                   {loads[2], solutions[2].field}});
  ASSERT_EQ(together.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const ErrorEstimate one = estimator.estimate(loads[i], solutions[i].field, place);
    EXPECT_NEAR(together[i].energy, one.energy, 1e-12 * one.energy);
    EXPECT_EQ(together[i].iterations, one.iterations);
    if (i == 0) {
      EXPECT_GT(one.stress_at.at(0).norm(), 0);
      EXPECT_LT((together[i].stress_at.at(0) - one.stress_at[0]).norm(), 1e-9 * one.stress_at[0].norm());
    } else {
      EXPECT_TRUE(together[i].stress_at.empty());
    }
  }
}

// Loads and supports of a linear field, with a curved model and weights.
TEST(ErrorEstimate, VanishesWhereTheSolutionIsInTheSpace) {
  const geometry::MultiPatch model = geometry::connect(geometry::cylinder_model({.patches_around = 2}));
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}, .refine = 1}, testing::steel);
  Eigen::Matrix3d gradient;
  gradient << 1, 2, 3, -1, 4, 0, 2, -2, 1;
  gradient *= 1e-3;
  p.supports = {{"inside", boundary(model, "inner"), PrescribedDisplacement{{0.1, 0.2, 0.3}, gradient}},
                {"outside", boundary(model, "outer"), PrescribedDisplacement{{0.1, 0.2, 0.3}, gradient}},
                {"planes", boundary(model, "start"), PrescribedDisplacement{{0.1, 0.2, 0.3}, gradient}},
                {"end", boundary(model, "end"), PrescribedDisplacement{{0.1, 0.2, 0.3}, gradient}},
                {"bottom", boundary(model, "bottom"), PrescribedDisplacement{{0.1, 0.2, 0.3}, gradient}},
                {"top", boundary(model, "top"), PrescribedDisplacement{{0.1, 0.2, 0.3}, gradient}}};
  // Rational functions are integrated to 1e-9.
  EXPECT_LT(estimate_error(p, solve_elasticity(p).field).relative, 1e-8);
}

// A quarter of a tube whose wall is held about its axis by springs that stand for a hold, under its weight.
ElasticityProblem held_tube(const CylindricalSupport& held, int degree, int refine) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::cylinder_model({.inner_radius = 0.4, .outer_radius = 1, .height = 1}));
  ElasticityProblem p =
      problem(model, {.degree = {degree, degree, degree}, .refine = refine}, testing::steel);
  p.supports = {{"shell", boundary(model, "outer"), held}};
  for (const char* plane : {"start", "bottom"})
    p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
  p.volume_loads = {{"weight", {PatchId(0)}, [](const Eigen::Vector3d& x) {
                       return Eigen::Vector3d(1e6 * (1 + x[2]), 0, 3e5);
                     }}};
  return p;
}

// The energy of what refinement changes.
double energy_of_change(const ElasticityProblem& coarse, const ElasticityProblem& fine) {
  const ElasticField before = solve_elasticity(coarse).field, after = solve_elasticity(fine).field;
  const geometry::NurbsVolume &from = before.patches[0], &to = after.patches[0];
  const geometry::NurbsVolume displacement(from.knots(), before.displacement[0], from.weights());
  const Eigen::Matrix3Xd change =
      after.displacement[0] - geometry::refined(displacement, to.knots()).control_points();
  const std::vector<PatchLayers> all = {{0, 0, to.knots(2).element_count()}};
  const solvers::Processes alone;
  return element_errors(fine.discretization, fine.materials, {change}, all, alone)[0][0].energy.sum();
}

// Springs hold at points, between which the solution gives way by a ten thousandth of what it does elsewhere.
// Held everywhere, as the raised functions are, that alone was ten times the error's energy at degree 3.
TEST(ErrorEstimate, IsThatOfThePartWhereSpringsStandForHolds) {
  for (const bool radial : {true, false})
    for (const int degree : {2, 3}) {
      const CylindricalSupport held{.radial = radial, .tangential = !radial};
      const ElasticityProblem given = held_tube(held, degree, 0);
      const double error = energy_of_change(given, held_tube(held, degree, 2));
      const double estimate = estimate_error(given, solve_elasticity(given).field).energy;
      EXPECT_GT(estimate, 0.25 * error) << radial << degree;
      EXPECT_LT(estimate, 4 * error) << radial << degree;
    }
}

TEST(ErrorEstimate, SaysByHowMuchStressIsOff) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::cylinder_model({.inner_radius = 1, .outer_radius = 2}));
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}, .refine = 1}, isotropic(1000, 0.3));
  for (const char* plane : {"start", "end", "bottom", "top"})
    p.supports.push_back({plane, boundary(model, plane), PlaneSupport{}});
  p.surface_loads = {pressure_load("pressure", boundary(model, "inner"), 10)};
  const ElasticitySolution solution = solve_elasticity(p);
  const Location wall = locate(solution.field, {1, 0, 0.25});
  const Eigen::Matrix3d stress = evaluate(solution.field, wall.patch, wall.parameter).stress;
  const ErrorEstimate estimate = estimate_error(p, solution.field, {{wall.patch, wall.parameter}});
  // Lame: the hoop stress at the inner wall is p (b^2 + a^2) / (b^2 - a^2), the radial one -p. One degree
  // more leaves about a fifth of the error.
  ASSERT_EQ(estimate.stress_at.size(), 1u);
  const double hoop = 50.0 / 3 - stress(1, 1), radial = -10 - stress(0, 0);
  EXPECT_GT(std::abs(radial), 0.1);
  EXPECT_NEAR(estimate.stress_at[0](1, 1), hoop, 0.35 * std::abs(hoop));
  EXPECT_NEAR(estimate.stress_at[0](0, 0), radial, 0.35 * std::abs(radial));
}

// Where stress has no limit, the elements at the edge have the largest errors.
TEST(ErrorEstimate, IsLargestAtAReentrantEdge) {
  const geometry::MultiPatch model = geometry::connect(geometry::bracket_model());
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}, .refine = 2}, testing::steel);
  p.supports = {{"end", boundary(model, "y_max"), PlaneSupport{}},
                {"side", boundary(model, "x_min"), PlaneSupport{}},
                {"bottom", boundary(model, "bottom"), PlaneSupport{}}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {0, -1, 0})};
  const ElasticitySolution solution = solve_elasticity(p);
  const ErrorEstimate estimate = estimate_error(p, solution.field);
  double largest = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t patch = 0; patch < estimate.elements.size(); ++patch) {
    const ElementTables tables(solution.field.patches[patch], 1);
    for (Eigen::Index e = 0; e < estimate.elements[patch].energy.size(); ++e)
      if (estimate.elements[patch].energy[e] > largest) {
        largest = estimate.elements[patch].energy[e];
        place = solution.field.patches[patch].point(tables.parameter(e, 0));
      }
  }
  const double element = 1.0 / 4;
  EXPECT_LT((place - Eigen::Vector3d(1, 1, place[2])).norm(), element) << place.transpose();
}

TEST(ErrorEstimate, IsRefusedWithoutTheMemoryForIt) {
  const ElasticityProblem given = bent_box(2, 0);
  const ElasticField field = solve_elasticity(given).field;
  ElasticityOptions options;
  options.solver.memory_limit = 1;
  EXPECT_ERROR(estimate_error(given, field, {}, options), ErrorCode::out_of_memory, "estimate of the error");
}

}  // namespace
}  // namespace isopatch::iga
