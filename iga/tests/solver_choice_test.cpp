#include "iga/solution/solver_choice.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <string>

#include "geometry/base/error.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/link.hpp"
#include "iga/assembly/pattern_forecast.hpp"
#include "iga/assembly/stiffness_pattern.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/solution/solver_bytes.hpp"
#include "iga/spaces/solution_knots.hpp"
#include "iga/tests/small_models.hpp"
#include "iga/tests/solver_options_table.hpp"
#include "solvers/memory.hpp"

namespace isopatch::iga {
namespace {

using solvers::Method;
using solvers::Operator;
using solvers::Preconditioner;
using ::testing::AllOf;
using testing::boundary;
using testing::for_all_options;
using ::testing::HasSubstr;
using testing::is_possible;
using testing::problem;
using testing::steel;

geometry::MultiPatch box(const std::array<int, 3>& patches, const Eigen::Vector3d& size = {1, 1, 1}) {
  return geometry::connect(geometry::box_model({.size = size, .patches = patches}));
}

RowNumbering numbering(const Discretization& d, Coupling coupling) {
  if (coupling == Coupling::elimination) {
    const GlobalNodes global = global_nodes(d);
    return {global.global_of, global.count()};
  }
  RowNumbering nodes{std::vector<int>(static_cast<std::size_t>(d.node_count())), d.node_count()};
  std::iota(nodes.row_of_node.begin(), nodes.row_of_node.end(), 0);
  return nodes;
}

void expect_exact_counts(const geometry::MultiPatch& model, const DiscretizationOptions& options,
                         int most_groups) {
  const Discretization d = discretize(model, options);
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  for (const Coupling coupling : {Coupling::elimination, Coupling::lagrange}) {
    const RowNumbering rows = numbering(d, coupling);
    const PatternForecast found =
        forecast_pattern(model, solution_knots(model, options), coupling, most_groups);
    EXPECT_EQ(found.nodes, d.node_count());
    EXPECT_EQ(found.rows, rows.rows);
    EXPECT_EQ(found.blocks, stiffness_size(spaces, whole_patches(spaces), rows).blocks) << name(coupling);
    EXPECT_EQ(found.multipliers,
              coupling == Coupling::lagrange ? 3 * (d.node_count() - global_nodes(d).count()) : 0);
    EXPECT_EQ(std::accumulate(found.groups.rows.begin(), found.groups.rows.end(), std::int64_t{0}),
              3 * found.rows + found.multipliers);
  }
}

TEST(PatternForecast, CountsRowsBlocksAndMultipliersExactly) {
  const geometry::MultiPatch curved = geometry::connect(geometry::box_model(
      {.patches = {2, 2, 2}, .distortion = 0.3, .curvature = 0.2, .orientation_seed = 7}));
  for (const int most_groups : {20'000, 300}) {
    expect_exact_counts(box({1, 1, 1}), {.degree = {1, 2, 3}, .refine = 3}, most_groups);
    expect_exact_counts(curved, {.degree = {3, 3, 3}, .elements_per_direction = {5, 6, 7}}, most_groups);
    expect_exact_counts(curved, {.degree = {4, 3, 2}, .refine = 2, .continuity = 1}, most_groups);
    expect_exact_counts(geometry::connect(geometry::link_model({})), {.degree = {3, 3, 2}, .refine = 1},
                        most_groups);
  }
}

// The groups' graph is a coarsening of the matrix: what it forecasts for single nodes is the factor itself.
TEST(FactorForecast, OfADenseMatrixIsExact) {
  const PatternForecast dense = forecast_pattern(
      box({1, 1, 1}), solution_knots(box({1, 1, 1}), {.degree = {3, 3, 3}}), Coupling::elimination);
  const solvers::FactorForecast factor = solvers::forecast_factor(dense.groups);
  EXPECT_EQ(factor.entries, 192 * 193 / 2);
  EXPECT_EQ(factor.flops, 192.0 * 193 * 385 / 6);
  EXPECT_EQ(factor.largest_front, 192.0 * 192);
}

SizeForecast size_of(const geometry::MultiPatch& model, const DiscretizationOptions& options,
                     Coupling coupling = Coupling::elimination, const Material& material = steel) {
  const std::vector<Material> materials(static_cast<std::size_t>(model.patch_count()), material);
  return forecast_size(model, solution_knots(model, options), materials, coupling, 1);
}

constexpr double plenty = 1e15;
std::string refusal(const SizeForecast& size, const solvers::SolverOptions& options,
                    double available = plenty) {
  try {
    solver_plans(size, options, available);
  } catch (const Error& error) {
    return fmt::format("{}: {}", isopatch::name(error.code()), error.what());
  }
  return "nothing was refused";
}

TEST(SolverPlans, LeaveNothingOpenAndKeepToWhatWasAskedFor) {
  for (const Coupling coupling : all_couplings) {
    const SizeForecast size = size_of(box({2, 1, 1}), {.degree = {2, 2, 2}, .refine = 2}, coupling);
    for_all_options([&](const solvers::SolverOptions& options) {
      if (!is_possible(options, coupling)) {
        EXPECT_THAT(refusal(size, options), HasSubstr("invalid_argument"));
        return;
      }
      for (const SolverPlan& plan : solver_plans(size, options, plenty)) {
        EXPECT_NE(plan.method, Method::automatic);
        EXPECT_NE(plan.form, Operator::automatic);
        EXPECT_FALSE(plan.reason.empty());
        EXPECT_GT(plan.predicted_bytes, 0);
        EXPECT_TRUE(options.method == Method::automatic || options.method == plan.method);
        EXPECT_TRUE(options.form == Operator::automatic || options.form == plan.form);
        EXPECT_TRUE(!is_iterative(plan) || options.preconditioner == plan.preconditioner);
      }
    });
  }
}

// What cannot go together, and what to take instead.
TEST(SolverPlans, PairsThatCannotBeAreToldWhatToTake) {
  struct Pair {
    Coupling coupling;
    Method method;
    Preconditioner preconditioner;
    Operator form;
    const char *reason, *instead;
  };
  constexpr Coupling elimination = Coupling::elimination, lagrange = Coupling::lagrange;
  constexpr Preconditioner multigrid = Preconditioner::multigrid, jacobi = Preconditioner::block_jacobi;
  constexpr Operator any = Operator::automatic, assembled = Operator::assembled,
                     matrix_free = Operator::matrix_free;
  const Pair pairs[] = {
      {lagrange, Method::cholmod, multigrid, any, "'cholmod' cannot treat the multipliers", "'mumps'"},
      {lagrange, Method::cg, multigrid, any, "'cg' cannot treat the multipliers", "'minres'"},
      {elimination, Method::minres, multigrid, any, "'minres' is for coupling 'lagrange'", "'cg'"},
      {elimination, Method::mumps, multigrid, matrix_free, "'mumps' factorizes a matrix", "'cg'"},
      {elimination, Method::cholmod, jacobi, any, "'block_jacobi' is for method 'cg'", "needs none"},
      {elimination, Method::cg, jacobi, matrix_free, "inverts blocks of a matrix", "'multigrid'"},
      {lagrange, Method::minres, jacobi, any, "cannot treat multipliers", "'multigrid' with method 'minres'"},
      {lagrange, Method::minres, multigrid, assembled, "iterates without a matrix", "operator = \"auto\""}};
  for (const Pair& pair : pairs) {
    const SizeForecast size = size_of(box({2, 1, 1}), {.degree = {2, 2, 2}}, pair.coupling);
    solvers::SolverOptions options;
    options.method = pair.method;
    options.preconditioner = pair.preconditioner;
    options.form = pair.form;
    EXPECT_THAT(refusal(size, options),
                AllOf(HasSubstr("invalid_argument"), HasSubstr(pair.reason), HasSubstr(pair.instead)));
  }
}

TEST(SolverPlans, WhatWorksOnOneProcessIsRefusedOnSeveral) {
  SizeForecast size = size_of(box({2, 1, 1}), {.degree = {2, 2, 2}});
  size.processes = 3;
  solvers::SolverOptions options;
  for (const Method method : {Method::cholmod, Method::umfpack}) {
    options.method = method;
    EXPECT_THAT(refusal(size, options),
                AllOf(HasSubstr("works on one process, and there are 3"), HasSubstr("'mumps'")));
  }
  options.method = Method::cg;
  options.preconditioner = Preconditioner::block_jacobi;
  EXPECT_THAT(refusal(size, options),
              AllOf(HasSubstr("'block_jacobi' works on one process"), HasSubstr("'multigrid'")));
}

TEST(SolverPlans, FitAllOfThemOrSayWhatWouldFit) {
  for (const Coupling coupling : all_couplings) {
    const SizeForecast size = size_of(box({2, 2, 2}), {.degree = {3, 3, 3}, .refine = 3}, coupling);
    for (const double available : {1e6, 1e8, 3e8, 1e9})
      for_all_options([&](const solvers::SolverOptions& options) {
        if (!is_possible(options, coupling)) return;
        const std::string message = refusal(size, options, available);
        if (message != "nothing was refused") {
          EXPECT_THAT(message, AllOf(HasSubstr("out_of_memory"), HasSubstr(" unknowns would fit")));
          return;
        }
        for (const SolverPlan& plan : solver_plans(size, options, available))
          EXPECT_LE(plan.predicted_bytes, available);
      });
  }
}

TEST(SolverPlans, FollowTheOperationsAndNotTheNumberOfUnknowns) {
  const SizeForecast cube =
      size_of(box({1, 1, 1}), {.degree = {3, 3, 3}, .elements_per_direction = {27, 27, 27}});
  const SizeForecast beam =
      size_of(box({1, 1, 1}, {100, 1, 1}), {.degree = {3, 3, 3}, .elements_per_direction = {2000, 1, 1}});
  ASSERT_GT(beam.unknowns, cube.unknowns);
  EXPECT_LT(beam.factor.flops, 0.02 * cube.factor.flops);
  EXPECT_EQ(solver_plans(beam, {}, plenty).front().method, Method::cholmod);
  EXPECT_EQ(solver_plans(cube, {}, plenty).front().method, Method::cg);
  EXPECT_THAT(solver_plans(cube, {}, plenty).front().reason, HasSubstr("Gflop"));
}

TEST(SolverPlans, GiveMemoryInUnitsThatAreNotZero) {
  EXPECT_EQ(gigabytes(2.7e6), "2.7 MB");
  EXPECT_EQ(gigabytes(4.9e7), "49 MB");
  EXPECT_EQ(gigabytes(8.2e8), "0.82 GB");
  EXPECT_EQ(gigabytes(2.03e11), "203 GB");
}

TEST(SolverPlans, FactorizeForManyLoadCasesWhereTheyIterateForOne) {
  SizeForecast cube = size_of(box({1, 1, 1}), {.degree = {3, 3, 3}, .elements_per_direction = {12, 12, 12}});
  ASSERT_EQ(solver_plans(cube, {}, plenty).front().method, Method::cg);
  cube.right_sides = 10;
  EXPECT_EQ(solver_plans(cube, {}, plenty).front().method, Method::cholmod);
  EXPECT_THAT(solver_plans(cube, {}, plenty).front().reason, HasSubstr("10 load cases"));
}

TEST(SolverPlans, FactorizeMoreWhereTheMaterialIsNearlyIncompressible) {
  const DiscretizationOptions options = {.degree = {3, 3, 3}, .elements_per_direction = {12, 12, 12}};
  EXPECT_EQ(solver_plans(size_of(box({1, 1, 1}), options), {}, plenty).front().method, Method::cg);
  const Material rubber = isotropic(1e6, 0.49, 1000, "rubber");
  EXPECT_EQ(solver_plans(size_of(box({1, 1, 1}), options, Coupling::elimination, rubber), {}, plenty)
                .front()
                .method,
            Method::cholmod);
}

TEST(SolverPlans, HaveTheOtherWayInReserve) {
  const SizeForecast small = size_of(box({2, 1, 1}), {.degree = {2, 2, 2}, .refine = 2});
  const std::vector<SolverPlan> plans = solver_plans(small, {}, plenty);
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].method, Method::cholmod);
  EXPECT_EQ(plans[1].method, Method::cg);
  const std::vector<SolverPlan> tied =
      solver_plans(size_of(box({2, 1, 1}), {.degree = {2, 2, 2}}, Coupling::lagrange), {}, plenty);
  ASSERT_EQ(tied.size(), 4u);
  EXPECT_EQ(tied[0].method, Method::mumps);
  EXPECT_EQ(tied[1].method, Method::minres);
  EXPECT_EQ(tied[2].method, Method::umfpack);
  EXPECT_EQ(tied[3].method, Method::cg);
  EXPECT_EQ(tied[3].form, solvers::Operator::matrix_free);
  EXPECT_EQ(solver_plans(small, {.method = Method::cholmod}, plenty).size(), 1u);
}

TEST(SolverPlans, IterateWhereFactorsDoNotFit) {
  const SizeForecast size =
      size_of(box({1, 1, 1}), {.degree = {3, 3, 3}, .elements_per_direction = {8, 8, 8}});
  const double of_factors = solver_plans(size, {.method = Method::cholmod}, plenty).front().predicted_bytes;
  const SolverPlan plan = solver_plans(size, {}, 0.9 * of_factors).front();
  EXPECT_EQ(plan.method, Method::cg);
  EXPECT_THAT(plan.reason, HasSubstr("factors would take about"));
}

TEST(RequireMemory, RefusesBeforeAnythingLargeIsMade) {
  const geometry::MultiPatch model = box({1, 1, 1}, {100, 1, 1});
  const DirectionKnots knots = solution_knots(model, {.degree = {2, 2, 2}, .refine = 8});  // 17 million nodes
  const std::int64_t before = solvers::resident_memory();
  try {
    require_memory(model, knots, {steel}, Coupling::elimination, NonMatchingCoupling::nitsche,
                   {.memory_limit = 4e9}, {});
    FAIL() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::out_of_memory);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("million unknowns"), HasSubstr("would fit"),
                                    ::testing::Not(HasSubstr("e+"))));
  }
  EXPECT_LT(solvers::resident_memory() - before, 100'000'000);
}

ElasticityProblem held(const geometry::MultiPatch& model, const DiscretizationOptions& options,
                       const Material& material = steel) {
  ElasticityProblem p = problem(model, options, material);
  p.supports = {{"clamp", boundary(p.discretization.model, "x_min"), PrescribedDisplacement{}}};
  p.surface_loads = {constant_traction("pull", boundary(p.discretization.model, "x_max"), {1e6, 2e6, 3e6})};
  return p;
}

/// The most memory that the process has held since `forget_peak`.
std::int64_t peak_memory() {
  std::ifstream file("/proc/self/status");
  std::string word;
  while (file >> word)
    if (std::int64_t kilobytes = 0; word == "VmHWM:" && file >> kilobytes) return 1024 * kilobytes;
  return 0;
}
bool forget_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

// Whatever is asked for: it is refused, or the process stays below its limit.
TEST(SolverMemory, TheLimitHoldsForAllMethodsPreconditionersOperatorsAndCouplings) {
  if (!forget_peak()) GTEST_SKIP() << "/proc/self/clear_refs cannot be written";
  const ElasticityProblem p =
      held(box({2, 1, 1}), {.degree = {3, 3, 3}, .elements_per_direction = {4, 4, 4}});
  for (const Coupling coupling : all_couplings) {
    int refused = 0, solved = 0;
    for_all_options([&](solvers::SolverOptions options) {
      if (!is_possible(options, coupling)) return;
      options.tolerance = 1e-4;
      options.memory_limit = static_cast<double>(solvers::resident_memory()) + 60e6;
      forget_peak();
      try {
        const ElasticitySolution s = solve_elasticity(p, {.coupling = coupling, .solver = options});
        ++solved;
        EXPECT_LE(peak_memory(), options.memory_limit)
            << solvers::name(s.solver.method) << ", " << s.predicted_bytes << " bytes foreseen";
      } catch (const Error& error) {
        ++refused;
        EXPECT_EQ(error.code(), ErrorCode::out_of_memory) << error.what();
      }
    });
    EXPECT_GT(refused, 1) << name(coupling);
    EXPECT_GT(solved, 1) << name(coupling);
  }
}

}  // namespace
}  // namespace isopatch::iga
