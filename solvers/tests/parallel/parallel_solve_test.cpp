#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/error.hpp"
#include "solvers/solve.hpp"
#include "solvers/tests/parallel/shared_system.hpp"
#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

constexpr int layer = 12;  // points of a layer of the grid
constexpr int layers = 6;

Eigen::VectorXd random_load(int rows) {
  std::mt19937 random(3);
  return random_matrix(rows, 1, random);
}

// Springs whose neighbours are at most two layers away.
LinearSystem grid(double ground) {
  LinearSystem system{spring_grid({4, 3, layers}, 2, ground), {}, random_load(3 * layer * layers)};
  return system;
}

// Ties of points far from each other, so of different processes.
ConstraintMatrix ties(int rows) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(9, rows);
  for (int i = 0; i < 9; ++i) {
    b(i, i) = 1;
    b(i, rows - 9 + i) = -1;
  }
  return sparse(b);
}

std::vector<std::vector<int>> sharing(const Processes& processes) {
  return overlapping(layer * layers, processes.count(), 2 * layer + layer);
}

SolverOptions factorized(const LinearSystem& system) {
  const bool definite = !system.has_constraints() && !system.rows.is_distributed();
  return {.method = definite ? Method::cholmod : Method::mumps};
}

void expect_same(const LinearSystem& whole) {
  const Processes processes = Processes::launched();
  const LinearSystem share = share_of(whole, sharing(processes), processes);
  const LinearSolution alone = solve(whole, factorized(whole)), shared = solve(share, factorized(share));
  EXPECT_LT((shared.x - share.rows.part(alone.x)).norm(), 1e-13 * alone.x.norm());
  EXPECT_EQ(share.rows.part(share.rows.whole(shared.x)), shared.x);
  EXPECT_LE(shared.report.relative_residual, 1e-15 * 100);
  const Eigen::VectorXd multipliers = share.multiplier_rows.whole(shared.multipliers);
  EXPECT_LT((multipliers - alone.multipliers).norm(), 1e-12 * (1 + alone.multipliers.norm()));
}

TEST(ParallelSolve, GivesTheSolutionOfOneProcess) {
  expect_same(grid(0.5));
}

TEST(ParallelSolve, GivesTheSolutionAndMultipliersOfOneProcess) {
  LinearSystem system = grid(0.5);
  system.constraints = ties(system.stiffness.rows());
  expect_same(system);
}

TEST(ParallelSolve, StiffSystemsKeepTheirConstraints) {
  LinearSystem system = grid(0.5);
  for (double& value : system.stiffness.values) value *= 2e11;
  system.load *= 1e6;
  system.constraints = ties(system.stiffness.rows());
  const Processes processes = Processes::launched();
  const LinearSystem share = share_of(system, sharing(processes), processes);
  const LinearSolution alone = solve(system, factorized(system)), shared = solve(share, factorized(share));
  EXPECT_LT((shared.x - share.rows.part(alone.x)).norm(), 1e-13 * alone.x.norm());
  const Eigen::VectorXd x = share.rows.whole(shared.x);
  EXPECT_LT((system.constraints * x).norm(), 1e-14 * x.norm());
}

TEST(ParallelSolve, ASingularSystemIsOneOnAllProcesses) {
  const Processes processes = Processes::launched();
  const LinearSystem share = share_of(grid(0), sharing(processes), processes);
  SolverOptions options;
  options.method = Method::mumps;
  try {
    solve(share, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::singular_system);
    EXPECT_THAT(error.what(), testing::HasSubstr("3 of its pivots are zero"));
  }
}

TEST(ParallelSolve, ZeroLoadGivesZeroAlsoWhereOneProcessHasLoad) {
  const Processes processes = Processes::launched();
  LinearSystem system = grid(0.5);
  system.load.setZero();
  LinearSystem share = share_of(system, sharing(processes), processes);
  EXPECT_EQ(solve(share, factorized(share)).x.norm(), 0);
  system.load[0] = 1;
  expect_same(system);
}

TEST(ParallelSolve, MethodsOfOneProcessAreRefused) {
  const Processes processes = Processes::launched();
  if (processes.count() == 1) GTEST_SKIP() << "there is one process";
  const LinearSystem share = share_of(grid(0.5), sharing(processes), processes);
  for (const Method method : {Method::cholmod, Method::umfpack, Method::cg}) {
    SolverOptions options;
    options.method = method;
    options.preconditioner = Preconditioner::block_jacobi;
    try {
      solve(share, options);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
      EXPECT_THAT(error.what(), testing::HasSubstr("works on one process"));
    }
  }
}

}  // namespace
}  // namespace isopatch::solvers
