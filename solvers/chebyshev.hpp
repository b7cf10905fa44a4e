#pragma once

#include <Eigen/Core>

#include "solvers/linear_operator.hpp"
#include "solvers/shared_rows.hpp"

namespace isopatch::solvers {

/// The Chebyshev iteration for A x = b with a preconditioner B: the polynomial in B A that is smallest on an
/// interval of eigenvalues.
struct ChebyshevInterval {
  double low = 0;
  double high = 0;
  int degree = 1;  ///< products with A and B for one call
};

/// `degree` steps from x = 0. Symmetric in b, and positive definite if no eigenvalue of B A is above `high`.
/// @source Saad, Iterative Methods for Sparse Linear Systems, 2003, algorithm 12.1
Eigen::VectorXd chebyshev(const VectorsOperator& product, const VectorsOperator& preconditioner,
                          const Eigen::VectorXd& b, const ChebyshevInterval& interval);
/// The same of each column.
Eigen::MatrixXd chebyshev_of_each(const VectorsOperator& product, const VectorsOperator& preconditioner,
                                  const Eigen::MatrixXd& b, const ChebyshevInterval& interval);

/// Largest eigenvalue of B A from a few steps of preconditioned conjugate gradients on a load that excites
/// all of them: below the true one by a few percent. The same for any number of processes but for round-off.
/// @throws Error singular_system  if A or B is not positive definite
/// @source Saad 2003, section 6.7.3 (Lanczos coefficients of conjugate gradients)
double largest_eigenvalue(const VectorsOperator& product, const VectorsOperator& preconditioner,
                          const SharedRows& rows, int steps);

}  // namespace isopatch::solvers
