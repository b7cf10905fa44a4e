#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/base/tests/expect_error.hpp"
#include "iga/problem/loads.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"

namespace isopatch::iga {
namespace {

using testing::boundary;

// A box of 8 distorted patches, clamped at one end and moved at the other in some cases.
ElasticityProblem boxed() {
  const geometry::MultiPatch model = testing::distorted_box();
  ElasticityProblem p = testing::problem(model, {.degree = {2, 2, 2}}, testing::steel);
  p.supports = {
      {"wall", boundary(model, "x_min"), PrescribedDisplacement{}},
      {"press", boundary(model, "x_max"), PrescribedDisplacement{{1e-4, std::nullopt, std::nullopt}}}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e6, 2e5, 0}),
                     pressure_load("wind", boundary(model, "y_max"), 3e5)};
  std::vector<PatchId> all;
  for (int i = 0; i < model.patch_count(); ++i) all.emplace_back(i);
  p.volume_loads = gravity("weight", all, {0, 0, -9.81e4}, p.materials);
  return p;
}

const LoadCases cases = {
    {{"service", {"pull", "weight"}, {}}, {"storm", {"wind"}, {}}, {"pressed", {}, {"press"}}},
    {{"worst", {1.35, -1.5, 2}}}};

struct Way {
  Coupling coupling;
  solvers::Method method;
  solvers::Operator form;
};

std::vector<Way> ways() {
  using solvers::Method;
  using solvers::Operator;
  return {{Coupling::elimination, Method::cholmod, Operator::automatic},
          {Coupling::elimination, Method::cg, Operator::matrix_free},
          {Coupling::elimination, Method::cg, Operator::assembled},
          {Coupling::lagrange, Method::mumps, Operator::automatic},
          {Coupling::lagrange, Method::minres, Operator::automatic}};
}

ElasticityOptions options_of(const Way& way) {
  ElasticityOptions options{.coupling = way.coupling};
  options.solver.method = way.method;
  options.solver.form = way.form;
  options.solver.tolerance = 1e-11;
  return options;
}

Eigen::Matrix3Xd coefficients(const ElasticField& field) {
  Eigen::Matrix3Xd all(3, 0);
  for (const Eigen::Matrix3Xd& of_patch : field.displacement) {
    all.conservativeResize(3, all.cols() + of_patch.cols());
    all.rightCols(of_patch.cols()) = of_patch;
  }
  return all;
}

template <class Items>
Eigen::Matrix3Xd forces(const Items& items) {
  Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = items[i].force;
  return all;
}

void expect_same(const ElasticitySolution& a, const ElasticitySolution& b) {
  // Both were iterated to 1e-11 or refined to round-off; the problem's condition is below 1e3.
  constexpr double allowed = 1e-8;
  EXPECT_LE((coefficients(a.field) - coefficients(b.field)).norm(), allowed * coefficients(b.field).norm());
  EXPECT_NEAR(a.results.internal_energy, b.results.internal_energy, allowed * b.results.internal_energy);
  EXPECT_NEAR(a.results.external_work, b.results.external_work, allowed * b.results.internal_energy);
  EXPECT_NEAR(a.results.max_von_mises.value, b.results.max_von_mises.value,
              1e2 * allowed * b.results.max_von_mises.value);
  EXPECT_LE((a.results.total_load - b.results.total_load).norm(), 1e-6);
  const Eigen::Matrix3Xd reactions = forces(b.results.reactions), multipliers = forces(b.multipliers);
  EXPECT_LE((forces(a.results.reactions) - reactions).norm(), 1e2 * allowed * reactions.norm());
  ASSERT_EQ(a.multipliers.size(), b.multipliers.size());
  EXPECT_LE((forces(a.multipliers) - multipliers).norm(), 1e2 * allowed * multipliers.norm());
}

TEST(LoadCases, EachIsTheSolutionOfItsOwnProblem) {
  const ElasticityProblem p = boxed();
  for (const Way& way : ways()) {
    const ElasticityOptions options = options_of(way);
    const std::vector<ElasticitySolution> together = solve_cases(p, cases, options);
    ASSERT_EQ(together.size(), 4u);
    for (std::size_t i = 0; i < cases.cases.size(); ++i) {
      SCOPED_TRACE(
          fmt::format("{} {} {}", name(way.coupling), solvers::name(way.method), cases.cases[i].name));
      expect_same(together[i], solve_elasticity(of_case(p, cases.cases[i]), options));
    }
  }
}

// What all solvers of cases begin with; that they agree shows nothing of it.
TEST(LoadCases, AbsentLoadsAreGoneAndSupportsThatDoNotMoveStandStill) {
  ElasticityProblem p = boxed();
  const auto& model = p.discretization.model;
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero();
  stretch(1, 1) = 1e-3;
  p.supports.push_back({"grip", boundary(model, "y_min"),
                        PrescribedDisplacement{{std::nullopt, 2e-4, std::nullopt}, stretch}});
  p.supports.push_back({"roller", boundary(model, "z_min"), PlaneSupport{-3e-4}});
  p.temperatures = {{"heat", {PatchId(0)}, {}}, {"frost", {PatchId(1)}, {}}};
  const LoadCase wanted{"one", {"wind", "frost"}, {"roller"}};
  const ElasticityProblem one = of_case(p, wanted);
  ASSERT_EQ(one.surface_loads.size(), 1u);
  EXPECT_EQ(one.surface_loads[0].name, "wind");
  EXPECT_TRUE(one.volume_loads.empty());
  ASSERT_EQ(one.temperatures.size(), 1u);
  EXPECT_EQ(one.temperatures[0].name, "frost");
  ASSERT_EQ(one.supports.size(), 4u);
  EXPECT_EQ(std::get<PrescribedDisplacement>(one.supports[1].condition),
            (PrescribedDisplacement{{0, std::nullopt, std::nullopt}}));
  EXPECT_EQ(std::get<PrescribedDisplacement>(one.supports[2].condition),
            (PrescribedDisplacement{{std::nullopt, 0, std::nullopt}}));
  EXPECT_EQ(std::get<PlaneSupport>(one.supports[3].condition).normal_displacement, -3e-4);
  const ElasticityProblem none = of_case(p, {"none", {}, {}});
  EXPECT_EQ(std::get<PlaneSupport>(none.supports[3].condition).normal_displacement, 0);
}

// A case that is a sum of others and one with little new in it: few iterations, if any, and the same
// solution.
TEST(LoadCases, WhatEarlierCasesHaveSolvedIsNotSolvedAgain) {
  const ElasticityProblem p = boxed();
  const LoadCases related = {{{"a", {"pull"}, {}}, {"b", {"wind"}, {}}, {"both", {"pull", "wind"}, {}}}};
  for (const Way& way : ways()) {
    if (way.method != solvers::Method::cg && way.method != solvers::Method::minres) continue;
    SCOPED_TRACE(solvers::name(way.method));
    const std::vector<ElasticitySolution> together = solve_cases(p, related, options_of(way));
    const ElasticitySolution alone = solve_elasticity(of_case(p, related.cases[2]), options_of(way));
    expect_same(together[2], alone);
    EXPECT_LE(together[2].solver.iterations, alone.solver.iterations / 2);
    EXPECT_LE(together[2].solver.energy_error, 1e-11);
    EXPECT_GT(together[1].solver.iterations, alone.solver.iterations / 2);
  }
}

// By hand: all loads and displacements scaled, in one problem that is solved alone.
TEST(LoadCases, ACombinationIsTheSolutionOfTheCombinedLoads) {
  ElasticityProblem sum = boxed();
  const geometry::MultiPatch& model = sum.discretization.model;
  sum.supports[1].condition = PrescribedDisplacement{{2 * 1e-4, std::nullopt, std::nullopt}};
  std::vector<PatchId> all;
  for (int i = 0; i < model.patch_count(); ++i) all.emplace_back(i);
  sum.volume_loads = gravity("weight", all, 1.35 * Eigen::Vector3d(0, 0, -9.81e4), sum.materials);
  sum.surface_loads = {
      constant_traction("pull", boundary(model, "x_max"), 1.35 * Eigen::Vector3d(1e6, 2e5, 0)),
      pressure_load("wind", boundary(model, "y_max"), -1.5 * 3e5)};
  for (const Way& way : ways()) {
    SCOPED_TRACE(fmt::format("{} {}", name(way.coupling), solvers::name(way.method)));
    const ElasticityOptions options = options_of(way);
    expect_same(solve_cases(boxed(), cases, options).back(), solve_elasticity(sum, options));
  }
}

// Supports that contradict each other in a case that has neither are no conflict; in one that has both they
// are.
TEST(LoadCases, ConflictsOfSupportsAreThoseOfACase) {
  ElasticityProblem p = boxed();
  p.supports.push_back({"other press", boundary(p.discretization.model, "x_max"),
                        PrescribedDisplacement{{3e-4, std::nullopt, std::nullopt}}});
  EXPECT_EQ(solve_cases(p, {{{"pull", {"pull"}, {}}}}).size(), 1u);
  EXPECT_ERROR(solve_cases(p, {{{"pressed", {"pull"}, {"press"}}}}), ErrorCode::conflict, "press");
}

TEST(LoadCases, WhatTheyNameMustExist) {
  const ElasticityProblem p = boxed();
  EXPECT_ERROR(solve_cases(p, {{{"a", {"pul"}, {}}}}), ErrorCode::invalid_argument, "load 'pul'");
  EXPECT_ERROR(solve_cases(p, {{{"a", {}, {"floor"}}}}), ErrorCode::invalid_argument, "support 'floor'");
  EXPECT_ERROR(solve_cases(p, {}), ErrorCode::invalid_argument, "no load case");
  EXPECT_ERROR(solve_cases(p, {{{"a", {"pull"}, {}}, {"a", {}, {}}}}), ErrorCode::invalid_argument, "'a'");
  EXPECT_ERROR(solve_cases(p, {{{"a", {"pull"}, {}}}, {{"b", {1, 2}}}}), ErrorCode::invalid_argument,
               "2 factors");
  EXPECT_ERROR(solve_cases(p, {{{"a", {"pull"}, {}}}, {{"b", {std::nan("")}}}}), ErrorCode::invalid_argument,
               "finite");
}

}  // namespace
}  // namespace isopatch::iga
