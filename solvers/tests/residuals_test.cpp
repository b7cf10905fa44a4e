#include "solvers/residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

// Solutions of an ill-conditioned system with constraints, whose residuals are round-off of large sums.
struct Sample {
  LinearSystem system;
  std::vector<Eigen::VectorXd> loads;
  std::vector<ScaledSystem> scaled;
  std::vector<const ScaledSystem*> pointers;
  Eigen::MatrixXd z;

  Sample(int rows, int constraints, int columns) {
    std::mt19937 random(5);
    Eigen::VectorXd scales(rows);
    for (int i = 0; i < rows; ++i) scales[i] = std::pow(10.0, i % 9);
    system.stiffness = from_dense(scales.asDiagonal() * random_spd(rows, random) * scales.asDiagonal());
    Eigen::MatrixXd signs = Eigen::MatrixXd::Zero(constraints, rows);
    for (int i = 0; i < constraints; ++i) {
      signs(i, i) = 1;
      signs(i, rows - 1 - i) = -1;
    }
    system.constraints = sparse(signs);
    z = random_matrix(rows + constraints, columns, random);
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(rows);
    for (int k = 0; k < columns; ++k) {
      const ScaledSystem of_zero(system, nothing);
      loads.push_back(-of_zero.residual(z.col(k)).head(rows));  // rounded to doubles
    }
    for (const Eigen::VectorXd& load : loads) scaled.emplace_back(system, load);
    for (const ScaledSystem& one : scaled) pointers.push_back(&one);
  }
};

TEST(Residuals, AreThoseOfEachRightSideInExtendedPrecision) {
  for (const int constraints : {0, 6})
    for (const int columns : {1, 2, 8, 11}) {
      const Sample sample(42, constraints, columns);
      const Eigen::MatrixXd all = residuals(sample.pointers, sample.z);
      for (int k = 0; k < columns; ++k) {
        const Eigen::VectorXd alone = sample.scaled[static_cast<std::size_t>(k)].residual(sample.z.col(k));
        const double load = sample.loads[static_cast<std::size_t>(k)].norm();
        // What rounding the loads left: a double's sums would be off by more than that themselves, an
        // extended number's 64 bits by a thousandth of it.
        EXPECT_GT(alone.head(42).norm(), 1e-18 * load);
        EXPECT_LT((all.col(k) - alone).norm(), 1e-18 * load) << k;
      }
    }
}

TEST(Residuals, TakeNumbersWhoseProductsOverflowADouble) {
  Sample sample(6, 0, 2);
  sample.z *= 1e304;
  const Eigen::MatrixXd all = residuals(sample.pointers, sample.z);
  const Eigen::VectorXd alone = sample.scaled[1].residual(sample.z.col(1));
  EXPECT_EQ(all.col(1), alone);
}

}  // namespace
}  // namespace isopatch::solvers
