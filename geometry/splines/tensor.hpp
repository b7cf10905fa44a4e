#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>

namespace isopatch::geometry {

/// Applies a matrix along one direction of a tensor of columns (first direction fastest).
/// @param values     (rows, product of sizes)
/// @param sizes      number of entries along each direction
/// @param direction  whose entries the matrix combines; matrix is (new size, sizes[direction])
/// @return           (rows, product of the new sizes)
template <int D, int Rows, class Matrix>
Eigen::Matrix<double, Rows, Eigen::Dynamic> apply_along(
    const Eigen::Matrix<double, Rows, Eigen::Dynamic>& values, const std::array<int, D>& sizes, int direction,
    const Matrix& matrix) {
  using Values = Eigen::Matrix<double, Rows, Eigen::Dynamic>;
  Eigen::Index inner = 1;
  Eigen::Index outer = 1;
  for (int d = 0; d < D; ++d)
    (d < direction ? inner : outer) *= d == direction ? 1 : sizes[static_cast<std::size_t>(d)];
  const Eigen::Index n = matrix.cols();
  const Eigen::Index m = matrix.rows();
  const Eigen::Index block = values.rows() * inner;
  Values result(values.rows(), inner * m * outer);
  for (Eigen::Index o = 0; o < outer; ++o) {
    const Eigen::Map<const Eigen::MatrixXd> in(values.data() + o * block * n, block, n);
    Eigen::Map<Eigen::MatrixXd> out(result.data() + o * block * m, block, m);
    out = in * matrix.transpose();
  }
  return result;
}

}  // namespace isopatch::geometry
