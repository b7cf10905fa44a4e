#include "geometry/base/sparse_lu.hpp"

#include <gtest/gtest.h>

namespace isopatch {
namespace {

// A cycle i -> i + 1 that no diagonal pivot solves.
Eigen::SparseMatrix<double> cycle(int n, double last) {
  Eigen::SparseMatrix<double> result(n, n);
  for (int i = 0; i < n; ++i) result.insert(i, (i + 1) % n) = i + 1 < n ? 2.0 : last;
  return result;
}

TEST(SparseLu, SolvesForSeveralRightSidesWithoutADiagonal) {
  const Eigen::SparseMatrix<double> matrix = cycle(5, 3);
  const Eigen::MatrixXd x = Eigen::MatrixXd::Identity(5, 2);
  const auto solution = solve_by_lu(matrix, matrix * x);
  ASSERT_TRUE(solution);
  EXPECT_LT((*solution - x).norm(), 1e-15);
}

TEST(SparseLu, HasNoSolutionOfASingularMatrix) {
  EXPECT_FALSE(solve_by_lu(cycle(5, 0), Eigen::MatrixXd::Ones(5, 1)));
}

}  // namespace
}  // namespace isopatch
