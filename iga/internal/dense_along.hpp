#pragma once

#include <Eigen/Core>
#include <array>

namespace isopatch::iga {

/// Applies a dense matrix along one direction of a tensor of scalars, first direction fastest. Parallel for
/// large tensors only, because waking threads costs more than a small product; the result does not depend on
/// the number of threads.
/// @param sizes  of the tensor, changed to those of the result
/// @tparam Matrix  Eigen::MatrixXd or the transposed of a constant one
template <class Matrix>
Eigen::VectorXd apply_dense_along(const Eigen::VectorXd& values, std::array<int, 3>& sizes, int direction,
                                  const Matrix& matrix);

}  // namespace isopatch::iga
