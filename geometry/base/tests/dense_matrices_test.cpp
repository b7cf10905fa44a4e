#include "geometry/base/dense_matrices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace isopatch {
namespace {

Eigen::MatrixXd symmetric(Eigen::Index n) {
  std::srand(3);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n);
  return a + a.transpose();
}

TEST(SymmetricEigen, DiagonalizesTheMatrix) {
  const Eigen::MatrixXd a = symmetric(7);
  const SymmetricEigen eigen = symmetric_eigen(a);
  EXPECT_LT((a * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), 1e-14 * a.norm());
  EXPECT_LT((eigen.vectors.transpose() * eigen.vectors - Eigen::MatrixXd::Identity(7, 7)).norm(), 1e-14);
  EXPECT_TRUE(std::is_sorted(eigen.values.begin(), eigen.values.end()));
  EXPECT_LT((symmetric_eigenvalues(a) - eigen.values).norm(), 1e-14 * a.norm());
}

TEST(SymmetricEigen, DiagonalizesAMatrixAndAMassAtOnce) {
  const Eigen::MatrixXd a = symmetric(6);
  const Eigen::MatrixXd mass = a * a + Eigen::MatrixXd::Identity(6, 6);
  const SymmetricEigen eigen = symmetric_eigen(a, mass);
  EXPECT_LT((a * eigen.vectors - mass * eigen.vectors * eigen.values.asDiagonal()).norm(), 1e-13 * a.norm());
  EXPECT_LT((eigen.vectors.transpose() * mass * eigen.vectors - Eigen::MatrixXd::Identity(6, 6)).norm(),
            1e-13);
}

TEST(SymmetricEigen, OfWhatIsNoNumberIsNone) {
  Eigen::MatrixXd a = symmetric(4);
  a(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(symmetric_eigen(a).values.array().isNaN().all());
  EXPECT_TRUE(symmetric_eigenvalues(a).array().isNaN().all());
}

TEST(PseudoInverse, InvertsOnTheRange) {
  const Eigen::MatrixXd a = symmetric(6).leftCols<3>() * symmetric(6).topRows<3>();  // of rank 3
  const Eigen::MatrixXd inverse = pseudo_inverse(a);
  EXPECT_LT((a * inverse * a - a).norm(), 1e-13 * a.norm());
  EXPECT_LT((inverse * a * inverse - inverse).norm(), 1e-13 * inverse.norm());
  const Eigen::MatrixXd square = symmetric(5) + 10 * Eigen::MatrixXd::Identity(5, 5);
  EXPECT_LT((pseudo_inverse(square) * square - Eigen::MatrixXd::Identity(5, 5)).norm(), 1e-14);
}

}  // namespace
}  // namespace isopatch
