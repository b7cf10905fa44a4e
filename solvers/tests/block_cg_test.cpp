#include "solvers/block_cg.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geometry/base/tests/expect_error.hpp"
#include "solvers/load_sequence.hpp"
#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

// A grid of springs, and its diagonal as preconditioner.
struct SpringSystem {
  SpringSystem() : a(to_dense(spring_grid({6, 6, 3}, 1, 0.05))) {
    system.rows = SharedRows(static_cast<int>(a.rows()) / 3);
    system.product = [this](const Eigen::VectorXd& x) {
      ++products;
      return Eigen::VectorXd(a * x);
    };
    system.preconditioner = [this](const Eigen::VectorXd& r) {
      return Eigen::VectorXd(r.cwiseQuotient(a.diagonal()));
    };
  }
  Eigen::MatrixXd random_loads(int count) const {
    std::mt19937 random(3);
    return random_matrix(static_cast<int>(a.rows()), count, random);
  }
  Eigen::MatrixXd a;
  OperatorSystem system;
  int products = 0;
};

std::vector<Eigen::VectorXd> columns_of(const Eigen::MatrixXd& loads) {
  std::vector<Eigen::VectorXd> result;
  for (const auto& load : loads.colwise()) result.emplace_back(load);
  return result;
}

TEST(BlockCg, SolvesEveryLoadInFewerIterationsThanOneAlone) {
  const SpringSystem sample;
  const Eigen::MatrixXd loads = sample.random_loads(6);
  const Eigen::MatrixXd preconditioned = sample.a.diagonal().cwiseInverse().asDiagonal() * loads;
  const BlockSolution found =
      solve_with_block_cg(sample.system, loads, preconditioned, {.tolerance = 1e-10}, {});
  OperatorSystem alone = sample.system;
  for (Eigen::Index j = 0; j < loads.cols(); ++j) {
    alone.load = loads.col(j);
    const LinearSolution one = solve_with_cg(alone, {.tolerance = 1e-10}, {});
    // An error of 1e-10 in the preconditioner's norm, and the condition of the grid is some hundreds.
    EXPECT_LT((sample.a * found.x.col(j) - alone.load).norm(), 1e-8 * alone.load.norm());
    EXPECT_LT(static_cast<int>(found.errors[static_cast<std::size_t>(j)].size()) - 1,
              0.8 * one.report.iterations);
  }
}

TEST(BlockCg, NamesADirectionWithoutEnergy) {
  SpringSystem sample;
  const Eigen::MatrixXd loads = sample.random_loads(2);
  sample.system.product = [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(-(sample.a * x)); };
  EXPECT_ERROR(solve_with_block_cg(sample.system, loads, loads, {}, {}), ErrorCode::singular_system,
               "without positive energy");
}

// A sum of two loads, a zero one, and one that is another but for a millionth of a third.
TEST(LoadSequence, TakesLoadsThatDependOnEachOtherTogether) {
  const SpringSystem sample;
  Eigen::MatrixXd loads = sample.random_loads(6);
  loads.col(2) = 2 * loads.col(0) - 3e5 * loads.col(1);
  loads.col(3).setZero();
  loads.col(5) = loads.col(1) + 1e-6 * loads.col(4);
  LoadSequence sequence(sample.system, KrylovMethod::cg);
  const std::vector<LinearSolution> found = sequence.solve_all(columns_of(loads), {.tolerance = 1e-10}, {});
  ASSERT_EQ(found.size(), 6u);
  for (Eigen::Index j = 0; j < loads.cols(); ++j) {
    const LinearSolution& one = found[static_cast<std::size_t>(j)];
    EXPECT_LE((sample.a * one.x - loads.col(j)).norm(), 1e-8 * loads.col(j).norm()) << j;
    EXPECT_LE(one.report.energy_error, 1e-10) << j;
    EXPECT_EQ(one.report.method, Method::cg);
  }
  EXPECT_GT(found[0].report.iterations, 10);
  EXPECT_EQ(found[2].report.iterations, 0);
  EXPECT_EQ(found[3].report.iterations, 0);
  EXPECT_EQ(found[5].report.iterations, 0);
}

}  // namespace
}  // namespace isopatch::solvers
