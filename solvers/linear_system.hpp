#pragma once

#include <Eigen/SparseCore>
#include <cstdint>

#include "solvers/block_matrix.hpp"
#include "solvers/shared_rows.hpp"

namespace isopatch::solvers {

using ConstraintMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// K x + B^T y = f, B x = g. Without constraints (no rows in B): K x = f with K symmetric positive definite.
/// With constraints K may be singular, but the whole system is regular: B has full rank and K is positive
/// definite on its kernel.
///
/// Spread over processes, each has K and B in its local rows, additive: the true matrices are the sums of
/// all; f, g, x and y are consistent. Alone, `rows` and `multiplier_rows` may be left as they are.
struct LinearSystem {
  SymmetricBlockMatrix stiffness;             ///< K
  ConstraintMatrix constraints;               ///< B, (multipliers, K rows), entries of the order of 1
  Eigen::VectorXd load;                       ///< f, (K rows), where g is 0; otherwise f and g
  SharedRows rows = SharedRows();             ///< block rows of K
  SharedRows multiplier_rows = SharedRows();  ///< rows of B, block size 1
  double assembly_seconds = 0;                ///< that it took to make them; for the report

  /// Constraints of the whole system.
  std::int64_t constraint_count() const {
    return rows.is_distributed() ? multiplier_rows.global_rows() : constraints.rows();
  }
  bool has_constraints() const { return constraint_count() > 0; }
};

/// Mean of the absolute diagonal entries of the whole K.
double mean_diagonal(const SymmetricBlockMatrix& stiffness, const SharedRows& rows);

}  // namespace isopatch::solvers
