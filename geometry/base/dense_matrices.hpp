#pragma once

#include <Eigen/Core>

namespace isopatch {

// Decompositions of dense matrices. Eigen's templates for these take seconds to compile wherever they are
// used, so they are compiled here, once.

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

/// The same of a symmetric matrix with these entries on its diagonal and beside it.
/// @param diagonal  (n), n > 0
/// @param beside    (n - 1)
SymmetricEigen tridiagonal_eigen(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside);

/// matrix * axes = axes * diagonal(values), with orthonormal axes.
struct PrincipalAxes {
  Eigen::Vector3d values;  // ascending
  Eigen::Matrix3d axes;    // a column for each value
};

/// Principal values and axes of a symmetric 3 x 3 matrix, of which the lower triangle is read; all NaN for a
/// matrix with NaN. Nothing is allocated.
PrincipalAxes principal_axes(const Eigen::Matrix3d& matrix);

/// matrix = vectors * (diagonal(values) 0) * orthogonal.
struct LeftSingular {
  Eigen::VectorXd values;   // min(m, n), descending
  Eigen::MatrixXd vectors;  // (m, m), orthogonal
};

/// Singular values and left singular vectors by Jacobi's rotations, accurate also where values are small.
/// @param matrix  (m, n)
LeftSingular left_singular(const Eigen::MatrixXd& matrix);

/// Solves matrix * x = right for a symmetric matrix, positive or negative semidefinite, by a pivoted Cholesky
/// factorization; all NaN where that meets a pivot 0 before its end.
/// @param matrix  (n, n), of which the lower triangle is read
/// @param right   (n)
/// @cost n^3 / 3 operations
Eigen::VectorXd solve_semidefinite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Solves matrix * x = right by LU factors with partial pivoting; for a singular matrix the result has what
/// is no finite number.
/// @param matrix  (n, n)
/// @param right   (n, k)
/// @cost 2/3 n^3 operations
Eigen::MatrixXd solve_by_lu(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The Moore-Penrose inverse, which is the inverse of a square matrix of full rank. What is below the unit
/// round-off times the larger size, relative to the largest pivot, counts as 0.
/// @param matrix  (m, n)
/// @return (n, m)
/// @cost O(m n min(m, n)) operations
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

}  // namespace isopatch
