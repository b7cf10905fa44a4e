#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "solvers/linear_system.hpp"

namespace isopatch::solvers {

/// Stores the upper blocks of a dense symmetric matrix, those that are zero left out.
inline SymmetricBlockMatrix from_dense(const Eigen::MatrixXd& dense) {
  SymmetricBlockMatrix matrix;
  const int n = static_cast<int>(dense.rows()) / 3;
  for (int row = 0; row < n; ++row) {
    for (int column = row; column < n; ++column) {
      const Eigen::Matrix3d block = dense.block<3, 3>(3 * row, 3 * column);
      if (column != row && block.isZero(0)) continue;
      matrix.columns.push_back(column);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) matrix.values.push_back(block(i, j));
    }
    matrix.row_start.push_back(static_cast<std::int64_t>(matrix.columns.size()));
  }
  return matrix;
}

/// Plain reference: every entry, both triangles.
inline Eigen::MatrixXd to_dense(const SymmetricBlockMatrix& matrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(matrix.rows(), matrix.rows());
  for (int row = 0; row < matrix.block_rows(); ++row)
    for (std::int64_t k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double value = matrix.values[9 * k + 3 * i + j];
          dense(3 * row + i, 3 * matrix.columns[k] + j) = value;
          dense(3 * matrix.columns[k] + j, 3 * row + i) = value;
        }
  return dense;
}

inline Eigen::MatrixXd random_matrix(int rows, int columns, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(random); });
}

/// Positive definite with eigenvalues in [1, 1 + 4 rows].
inline Eigen::MatrixXd random_spd(int rows, std::mt19937& random) {
  const Eigen::MatrixXd a = random_matrix(rows, rows, random);
  return a * a.transpose() + Eigen::MatrixXd::Identity(rows, rows);
}

inline ConstraintMatrix sparse(const Eigen::MatrixXd& dense) {
  return dense.sparseView();
}

/// Springs along a grid of points that couple neighbours up to `reach` apart in every direction, with a
/// random positive definite block each, plus `ground` times the identity at each point. With ground = 0 the
/// three translations are free.
inline SymmetricBlockMatrix spring_grid(const std::array<int, 3>& points, int reach, double ground,
                                        unsigned seed = 7) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto [l, m, n] = points;
  SymmetricBlockMatrix matrix;
  std::vector<Eigen::Matrix3d> diagonal(static_cast<std::size_t>(l) * m * n,
                                        ground * Eigen::Matrix3d::Identity());
  std::vector<std::int64_t> diagonal_position;
  for (int index = 0; index < l * m * n; ++index) {
    const int i = index % l, j = index / l % m, k = index / (l * m);
    diagonal_position.push_back(matrix.blocks());
    matrix.columns.push_back(index);
    matrix.values.insert(matrix.values.end(), 9, 0.0);
    for (int c = k; c <= std::min(k + reach, n - 1); ++c)
      for (int b = std::max(j - reach, 0); b <= std::min(j + reach, m - 1); ++b)
        for (int a = std::max(i - reach, 0); a <= std::min(i + reach, l - 1); ++a) {
          const int other = a + l * (b + m * c);
          if (other <= index) continue;
          const Eigen::Vector3d d(a - i, b - j, c - k);
          const Eigen::Vector3d e =
              d.normalized() + 0.1 * Eigen::Vector3d(uniform(random), uniform(random), 0.3);
          const Eigen::Matrix3d spring =
              (e * e.transpose() + 0.2 * Eigen::Matrix3d::Identity()) / d.squaredNorm();
          diagonal[index] += spring;
          diagonal[other] += spring;
          matrix.columns.push_back(other);
          for (int r = 0; r < 3; ++r)
            for (int s = 0; s < 3; ++s) matrix.values.push_back(-spring(r, s));
        }
    matrix.row_start.push_back(matrix.blocks());
  }
  for (std::size_t index = 0; index < diagonal.size(); ++index)
    for (int r = 0; r < 9; ++r)
      matrix.values[9 * diagonal_position[index] + r] = diagonal[index](r / 3, r % 3);
  return matrix;
}

}  // namespace isopatch::solvers
