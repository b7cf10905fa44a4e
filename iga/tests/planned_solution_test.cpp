#include "iga/solution/planned_solution.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "iga/solution/likely_cause.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/tests/small_models.hpp"
#include "iga/tests/solver_options_table.hpp"

namespace isopatch::iga {
namespace {

using solvers::Method;
using ::testing::AllOf;
using testing::boundary;
using testing::for_all_options;
using ::testing::HasSubstr;
using testing::is_possible;
using ::testing::Not;
using testing::problem;

const Material soft_steel = isotropic(200e9, 0.3, 7850, "steel");

/// A sheet of 1 m x 1 m, clamped all round, under 1 Pa.
ElasticityProblem sheet(double thickness, const Material& material = soft_steel) {
  const geometry::MultiPatch model =
      geometry::connect(geometry::box_model({.size = {1, 1, thickness}, .patches = {2, 2, 1}}));
  ElasticityProblem p = problem(model, {.degree = {4, 4, 4}, .elements_per_direction = {4, 4, 1}}, material);
  for (const char* side : {"x_min", "x_max", "y_min", "y_max"})
    p.supports.push_back({side, boundary(model, side), PrescribedDisplacement{}});
  p.surface_loads = {pressure_load("wind", boundary(model, "z_max"), 1)};
  return p;
}

// Deflection of a clamped square plate: 0.00126532 q a^4 / D (Timoshenko, Woinowsky-Krieger, table 35).
double kirchhoff(double thickness) {
  return 0.00126532 * 12 * (1 - 0.3 * 0.3) / (200e9 * std::pow(thickness, 3));
}

TEST(PlannedSolution, ThinSheetsAreSolvedByWhatWorks) {
  for (const double thickness : {1e-3, 1e-4}) {
    const ElasticitySolution s = solve_elasticity(sheet(thickness));
    // These elements leave 1.6 and 1.8 % of the deflection.
    EXPECT_NEAR(s.results.max_displacement.value / kirchhoff(thickness), 1, 0.03) << thickness;
    EXPECT_NEAR(s.results.external_work / s.results.internal_energy, 1, 1e-9) << thickness;
    EXPECT_EQ(s.solver.method, Method::cg);
    EXPECT_THAT(s.solver.reason, AllOf(HasSubstr("cholmod failed: "), HasSubstr("; so iterations")))
        << thickness;
    EXPECT_GE(s.predicted_bytes, s.solver.memory_bytes);
  }
}

// The matrix with multipliers is singular to double precision; iterations whose unknowns are jumps are not
// hurt.
TEST(PlannedSolution, ThinSheetsWithMultipliersAreSolvedByIterations) {
  for (const double thickness : {1e-3, 1e-4}) {
    const ElasticityProblem p = sheet(thickness);
    const ElasticitySolution tied = solve_elasticity(p, {.coupling = Coupling::lagrange});
    const ElasticitySolution merged = solve_elasticity(p);
    EXPECT_NEAR(tied.results.max_displacement.value / merged.results.max_displacement.value, 1, 1e-6);
    EXPECT_EQ(tied.solver.method, Method::minres) << tied.solver.reason;
    EXPECT_THAT(tied.solver.reason, AllOf(HasSubstr("mumps failed: "), HasSubstr("so iterations with")));
    ASSERT_EQ(tied.multipliers.size(), merged.multipliers.size());
    EXPECT_FALSE(tied.multipliers.empty());
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < tied.multipliers.size(); ++i) {
      largest = isopatch::larger(largest, merged.multipliers[i].force.norm());
      difference =
          isopatch::larger(difference, (tied.multipliers[i].force - merged.multipliers[i].force).norm());
    }
    EXPECT_GT(largest, 0);
    EXPECT_LT(difference, 1e-4 * largest);
  }
}

std::string failure(const ElasticityProblem& p, const ElasticityOptions& options) {
  try {
    solve_elasticity(p, options);
  } catch (const Error& error) {
    return fmt::format("{}: {}", isopatch::name(error.code()), error.what());
  }
  return "nothing was thrown";
}

TEST(PlannedSolution, TooFewGaussPointsAreNamedAndNotARigidMotion) {
  const std::string message = failure(sheet(0.1), {.quadrature_points = 1});
  EXPECT_THAT(message, AllOf(HasSubstr("singular_system"),
                             HasSubstr("1 Gauss point per direction is too few for degree 4"),
                             Not(HasSubstr("rigid")), Not(HasSubstr("hardly held"))));
}

TEST(LikelyCause, NamesPoissonsRatioMaterialsAndThinPatches) {
  EXPECT_THAT(likely_cause(sheet(0.1, isotropic(1e9, 0.4999999)), 0),
              AllOf(HasSubstr("Poisson's ratio of 0.4999999"), Not(HasSubstr("held"))));
  EXPECT_THAT(likely_cause(sheet(1e-4), 0), HasSubstr("times as long as thick"));
  ElasticityProblem mixed = sheet(0.1);
  mixed.materials[1] = isotropic(200, 0.3);  // GPa without its unit
  EXPECT_THAT(likely_cause(mixed, 0), HasSubstr("Young's modulus 1e+09 times"));
  EXPECT_THAT(likely_cause(sheet(0.1), 0), HasSubstr("few points only"));
  EXPECT_THAT(likely_cause(sheet(0.1), 3),
              HasSubstr("3 Gauss points per direction are too few for degree 4"));
}

ElasticityProblem pulled_box(int refine) {
  const geometry::MultiPatch model = geometry::connect(geometry::box_model({.patches = {2, 1, 1}}));
  ElasticityProblem p = problem(model, {.degree = {2, 2, 2}, .refine = refine}, soft_steel);
  p.supports = {{"clamp", boundary(model, "x_min"), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("pull", boundary(model, "x_max"), {1e6, 2e6, 3e6})};
  return p;
}

// Every different plan that options can lead to.
std::vector<SolverPlan> all_plans(const SizeForecast& size) {
  std::vector<SolverPlan> result;
  for_all_options([&](const solvers::SolverOptions& options) {
    if (!is_possible(options, size.coupling)) return;
    for (const SolverPlan& plan : solver_plans(size, options, 1e15)) {
      const auto same = [&](const SolverPlan& other) {
        return other.method == plan.method && other.preconditioner == plan.preconditioner &&
               other.form == plan.form;
      };
      if (std::none_of(result.begin(), result.end(), same)) result.push_back(plan);
    }
  });
  return result;
}

// The report tells what ran, from the solver itself; its memory is within the forecast, which is rather too
// high.
TEST(PlannedSolution, EveryPlanRunsAsItIsWritten) {
  for (const Coupling coupling : all_couplings)
    for (const int refine : {0, 2}) {
      const ElasticityProblem p = pulled_box(refine);
      const CoupledProblem coupled = coupled_problem(p, {.coupling = coupling});
      const std::vector<SolverPlan> plans =
          all_plans(forecast_size(p.discretization, p.materials, coupling, 1));
      EXPECT_EQ(plans.size(), coupling == Coupling::elimination ? 6u : 4u);
      double first_work = 0;
      for (const SolverPlan& plan : plans) {
        SCOPED_TRACE(fmt::format("{}, {}, {}, {}, refined {} times", name(coupling),
                                 solvers::name(plan.method), solvers::name(plan.preconditioner),
                                 solvers::name(plan.form), refine));
        const PlannedSolution planned = solve_as_planned(coupled, {plan}, {}, {});
        const solvers::SolveReport& report = planned.solutions.front().report;
        EXPECT_EQ(report.method, plan.method);
        EXPECT_EQ(report.form, plan.form);
        const bool multigrid =
            is_iterative(plan) && plan.preconditioner == solvers::Preconditioner::multigrid;
        EXPECT_EQ(report.levels > 0, multigrid);
        EXPECT_EQ(report.matrix_nonzeros > 0, plan.form == solvers::Operator::assembled);
        EXPECT_EQ(report.factor_nonzeros > 0, !is_iterative(plan));
        EXPECT_GT(report.memory_bytes, 0);
        EXPECT_LE(static_cast<double>(report.memory_bytes), plan.predicted_bytes);
        EXPECT_EQ(planned.predicted_bytes, plan.predicted_bytes);
        const double work =
            coupled.right_sides.front().load.cwiseProduct(planned.solutions.front().displacement).sum();
        if (first_work == 0) first_work = work;
        EXPECT_NEAR(work / first_work, 1, 1e-8);
      }
    }
}

}  // namespace
}  // namespace isopatch::iga
