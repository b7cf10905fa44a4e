#pragma once

#include <Eigen/SparseCore>
#include <optional>

namespace isopatch {

/// Solves matrix * x = right by LU factors with partial pivoting; nothing if the matrix is singular. Eigen's
/// templates for this take seconds to compile, so they are compiled here, once.
/// @param matrix  (n, n), compressed or not
/// @param right   (n, k)
/// @return (n, k)
std::optional<Eigen::MatrixXd> solve_by_lu(const Eigen::SparseMatrix<double>& matrix,
                                           const Eigen::MatrixXd& right);

}  // namespace isopatch
