#include "solvers/condition.hpp"
#include "geometry/base/dense_matrices.hpp"

#include <gtest/gtest.h>

#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

double number_of(const Eigen::MatrixXd& dense) {
  const Eigen::VectorXd values = symmetric_eigenvalues(dense).cwiseAbs();
  return values.maxCoeff<Eigen::PropagateNaN>() / values.minCoeff<Eigen::PropagateNaN>();
}

TEST(Condition, IsThatOfTheDenseMatrix) {
  LinearSystem system;
  system.stiffness = spring_grid({5, 4, 3}, 1, 0.01);
  system.load = Eigen::VectorXd::Zero(system.stiffness.rows());
  const double exact = number_of(to_dense(system.stiffness));
  EXPECT_GT(exact, 100);
  EXPECT_NEAR(estimate_condition(system).number() / exact, 1, 1e-2);
}

// Two grids that float, one held through the other by constraints.
TEST(Condition, IsThatOfTheSaddlePoint) {
  const SymmetricBlockMatrix held = spring_grid({4, 3, 3}, 1, 0.01, 3);
  const SymmetricBlockMatrix loose = spring_grid({4, 3, 3}, 1, 0, 4);
  const int n = held.rows();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  dense.topLeftCorner(n, n) = to_dense(held);
  dense.bottomRightCorner(n, n) = to_dense(loose);
  Eigen::MatrixXd ties = Eigen::MatrixXd::Zero(12, 2 * n);
  for (int i = 0; i < 12; ++i) {
    ties(i, i) = 1;
    ties(i, n + i) = -1;
  }
  LinearSystem system;
  system.stiffness = from_dense(dense);
  system.constraints = sparse(ties);
  system.load = Eigen::VectorXd::Zero(2 * n);
  const double scale = mean_diagonal(system.stiffness);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(2 * n + 12, 2 * n + 12);
  whole.topLeftCorner(2 * n, 2 * n) = dense;
  whole.bottomLeftCorner(12, 2 * n) = scale * ties;
  whole.topRightCorner(2 * n, 12) = scale * ties.transpose();
  EXPECT_NEAR(estimate_condition(system).number() / number_of(whole), 1, 1e-2);
}

}  // namespace
}  // namespace isopatch::solvers
