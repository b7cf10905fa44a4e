#pragma once

#include <Eigen/Core>

#include "solvers/linear_operator.hpp"

namespace isopatch::solvers {

struct LanczosOptions {
  int count = 10;            ///< eigenpairs wanted, positive
  double tolerance = 1e-10;  ///< of an eigenvalue's residual in the norm of the mass, relative to the value
  int most_vectors = 400;    ///< of the basis: eigenpairs must have converged by then
};

struct EigenPairs {
  Eigen::VectorXd values;   ///< decreasing; those wanted, and as many as had converged with them
  Eigen::MatrixXd vectors;  ///< one column each, orthonormal in the inner product of the mass
  double next_value = 0;    ///< the best estimate of the one that follows
  int applications = 0;     ///< vectors to which the operator was applied
};

/// The largest eigenvalues of an operator that is self-adjoint in the inner product of a mass, by block
/// Lanczos with full orthogonalization: a block of as many vectors as an eigenvalue has copies finds them
/// all.
///
/// @param apply  O, with x.M O y = O x.M y, positive
/// @param mass   M, positive semidefinite; vectors without mass are not seen
/// @param start  a block of independent vectors, at least as many as the largest multiplicity
/// @throws Error not_converged  with the number of pairs that have
/// @cost   one application of either operator per vector of the basis, and its orthogonalization: O(rows
///         vectors^2) flops and 2 vectors each in memory
/// @source Golub, Underwood 1977; Parlett, The Symmetric Eigenvalue Problem, 1998, chapter 13
EigenPairs largest_eigenpairs(const BlockOperator& apply, const BlockOperator& mass,
                              const Eigen::MatrixXd& start, const LanczosOptions& options);

}  // namespace isopatch::solvers
