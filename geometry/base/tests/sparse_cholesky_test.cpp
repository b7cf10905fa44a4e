#include "geometry/base/sparse_cholesky.hpp"

#include <gtest/gtest.h>

namespace isopatch {
namespace {

Eigen::SparseMatrix<double> sparse(const Eigen::MatrixXd& dense) {
  return dense.sparseView();
}

TEST(SparseCholesky, Solves) {
  Eigen::Matrix3d matrix;
  matrix << 4, 1, 0, 1, 3, -1, 0, -1, 2;
  const SparseCholesky factors(sparse(matrix));
  ASSERT_TRUE(factors.is_positive_definite());
  const Eigen::Vector3d x(1, -2, 3);
  EXPECT_LT((factors.solve(matrix * x) - x).norm(), 1e-14);
}

TEST(SparseCholesky, KnowsIndefiniteMatrices) {
  Eigen::Matrix2d matrix;
  matrix << 1, 2, 2, 1;
  EXPECT_FALSE(SparseCholesky(sparse(matrix)).is_positive_definite());
}

}  // namespace
}  // namespace isopatch
