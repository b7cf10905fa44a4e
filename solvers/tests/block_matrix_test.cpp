#include "solvers/block_matrix.hpp"
#include "solvers/block_product.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "solvers/tests/sample_systems.hpp"

namespace isopatch::solvers {
namespace {

TEST(SymmetricBlockMatrix, CountsEntriesOfBothTriangles) {
  std::mt19937 random(1);
  const SymmetricBlockMatrix matrix = from_dense(random_spd(12, random));
  EXPECT_EQ(matrix.block_rows(), 4);
  EXPECT_EQ(matrix.blocks(), 10);
  EXPECT_EQ(matrix.nonzeros(), 144);
  EXPECT_EQ(matrix.bytes(), 5 * 8 + 10 * 4 + 90 * 8);
}

TEST(SymmetricBlockMatrix, MultipliesLikeTheDenseMatrix) {
  std::mt19937 random(2);
  const Eigen::MatrixXd dense = random_spd(30, random);
  const Eigen::VectorXd x = random_matrix(30, 1, random);
  const Eigen::VectorXd expected = dense * x;
  EXPECT_LE((multiply(from_dense(dense), x) - expected).norm(), 1e-14 * expected.norm());
}

TEST(SymmetricBlockMatrix, MultipliesManyRangesLikeTheDenseMatrix) {
  const SymmetricBlockMatrix matrix = spring_grid({9, 9, 9}, 2, 1.0);
  ASSERT_GT(matrix.blocks(), 1 << 14);  // so that rows are split into ranges
  std::mt19937 random(3);
  const Eigen::VectorXd x = random_matrix(matrix.rows(), 1, random);
  const Eigen::VectorXd expected = to_dense(matrix) * x;
  EXPECT_LE((multiply(matrix, x) - expected).norm(), 1e-14 * expected.norm());
}

TEST(SymmetricBlockMatrix, MultipliesTheSameWithAnyNumberOfThreads) {
  const SymmetricBlockMatrix matrix = spring_grid({9, 9, 9}, 2, 1.0);
  std::mt19937 random(4);
  const Eigen::VectorXd x = random_matrix(matrix.rows(), 1, random);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Eigen::VectorXd one = multiply(matrix, x);
  omp_set_num_threads(3);
  const Eigen::VectorXd three = multiply(matrix, x);
  omp_set_num_threads(threads);
  EXPECT_EQ(one, three);
}

TEST(SymmetricBlockMatrix, MeanDiagonalTakesAbsoluteValues) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6, 6);
  dense.diagonal() << 1, -2, 3, -4, 5, 6;
  EXPECT_DOUBLE_EQ(mean_diagonal(from_dense(dense)), 3.5);
  EXPECT_EQ(mean_diagonal({}), 0);
}

}  // namespace
}  // namespace isopatch::solvers
