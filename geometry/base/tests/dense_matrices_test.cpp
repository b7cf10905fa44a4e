#include "geometry/base/dense_matrices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

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

TEST(SymmetricEigen, DiagonalizesATridiagonalMatrix) {
  // The second difference of n points has the eigenvalues 2 - 2 cos(pi k / (n + 1)).
  const int n = 9;
  const SymmetricEigen eigen =
      tridiagonal_eigen(Eigen::VectorXd::Constant(n, 2), Eigen::VectorXd::Constant(n - 1, -1));
  for (int k = 1; k <= n; ++k) {
    const double step = std::numbers::pi * k / (n + 1);
    EXPECT_NEAR(eigen.values[k - 1], 2 - 2 * std::cos(step), 1e-14);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(std::abs(eigen.vectors(i, k - 1)),
                  std::abs(std::sqrt(2.0 / (n + 1)) * std::sin(step * (i + 1))), 1e-14);
  }
}

TEST(PrincipalAxes, DiagonalizeTheMatrix) {
  const Eigen::Matrix3d a = symmetric(3);
  const PrincipalAxes principal = principal_axes(a);
  const Eigen::Matrix3d back = principal.axes * principal.values.asDiagonal() * principal.axes.transpose();
  EXPECT_LT((back - a).norm(), 1e-14 * a.norm());
  EXPECT_LT((principal.axes.transpose() * principal.axes - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_TRUE(std::is_sorted(principal.values.begin(), principal.values.end()));
}

TEST(PrincipalAxes, OfWhatIsNoNumberAreNone) {
  Eigen::Matrix3d a = symmetric(3);
  a(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(principal_axes(a).values.array().isNaN().all());
  EXPECT_TRUE(principal_axes(a).axes.array().isNaN().all());
}

TEST(LeftSingular, IsAccurateForSmallValuesToo) {
  // Columns along three known directions, with lengths whose squares differ by more than round-off.
  const Eigen::Matrix3d turn = symmetric_eigen(symmetric(3)).vectors;
  const Eigen::Vector3d lengths(1, 1e-5, 1e-9);
  Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(3, 5);
  wide.leftCols<3>() = turn * lengths.asDiagonal();
  const LeftSingular parts = left_singular(wide);
  ASSERT_EQ(parts.vectors.cols(), 3);
  EXPECT_LT((parts.values - lengths).cwiseQuotient(lengths).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-6);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(parts.vectors.col(k).dot(turn.col(k))), 1, 1e-12);
}

TEST(SolveSemidefinite, SolvesWhereAPivotIsFarDown) {
  const Eigen::MatrixXd root = symmetric(7);
  const Eigen::MatrixXd a = root * root;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(7, -1, 2);
  EXPECT_LT((a * solve_semidefinite(a, a * x) - a * x).norm(), 1e-13 * a.norm());
  Eigen::MatrixXd graded = Eigen::Vector3d(1e-8, 1, 1e8).asDiagonal();
  EXPECT_LT((solve_semidefinite(graded, Eigen::Vector3d(1e-8, 1, 1e8)) - Eigen::Vector3d::Ones()).norm(),
            1e-15);
}

TEST(SolveSemidefinite, OfAnIndefiniteMatrixWithoutPivotsIsNoNumber) {
  Eigen::Matrix2d swap;
  swap << 0, 1, 1, 0;
  EXPECT_TRUE(solve_semidefinite(swap, Eigen::Vector2d(1, 2)).array().isNaN().all());
}

TEST(SolveByLu, SolvesForSeveralRightSides) {
  Eigen::MatrixXd a = symmetric(6);
  a(0, 0) = 0;   // so that rows must be exchanged
  a(1, 3) += 1;  // and it is not symmetric
  const Eigen::MatrixXd x = symmetric(6).leftCols<2>();
  EXPECT_LT((solve_by_lu(a, a * x) - x).norm(), 1e-13 * x.norm());
}

TEST(SolveByLu, OfASingularMatrixIsNoNumber) {
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(3, 3);
  EXPECT_FALSE(solve_by_lu(ones, Eigen::Vector3d(1, 2, 3)).allFinite());
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
