#pragma once

#include <Eigen/Core>

namespace isopatch {

// Decompositions of dense matrices of any size. Eigen's templates for these take seconds to compile wherever
// they are used, so they are compiled here, once.

/// matrix * vectors = mass * vectors * diagonal(values), with vectors^T mass vectors = 1.
struct SymmetricEigen {
  Eigen::VectorXd values;   // ascending
  Eigen::MatrixXd vectors;  // (n, n), a column for each value
};

/// Eigenvalues and vectors of a symmetric matrix, of which the lower triangle is read, by QR steps; all NaN
/// if they do not converge, as for a matrix with NaN.
/// @param matrix  (n, n), n > 0
/// @cost 9 n^3 operations
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

/// The same of the pencil (matrix, mass).
/// @param mass  (n, n), positive definite
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& mass);

/// The eigenvalues of a symmetric matrix alone, ascending. @cost 4/3 n^3 operations
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// The Moore-Penrose inverse, which is the inverse of a square matrix of full rank. What is below the unit
/// round-off times the larger size, relative to the largest pivot, counts as 0.
/// @param matrix  (m, n)
/// @return (n, m)
/// @cost O(m n min(m, n)) operations
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

}  // namespace isopatch
