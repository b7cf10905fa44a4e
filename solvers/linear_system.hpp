#pragma once

#include <Eigen/SparseCore>

#include "solvers/block_matrix.hpp"

namespace isopatch::solvers {

using ConstraintMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// K x + B^T y = f, B x = 0. Without constraints (no rows in B): K x = f with K symmetric positive definite.
/// With constraints K may be singular, but the whole system is regular: B has full rank and K is positive
/// definite on its kernel.
struct LinearSystem {
  SymmetricBlockMatrix stiffness;  ///< K
  ConstraintMatrix constraints;    ///< B, (multipliers, K rows), entries of the order of 1
  Eigen::VectorXd load;            ///< f
  bool has_constraints() const { return constraints.rows() > 0; }
};

}  // namespace isopatch::solvers
