#pragma once

#include <cstdint>
#include <vector>

#include "solvers/linear_system.hpp"

namespace isopatch::solvers {

/// Compressed rows of a scalar matrix, columns increasing.
template <class Index>
struct CompressedRows {
  std::vector<Index> row_start;
  std::vector<Index> columns;
  std::vector<double> values;
  std::int64_t bytes() const {
    return static_cast<std::int64_t>((row_start.size() + columns.size()) * sizeof(Index) +
                                     values.size() * sizeof(double));
  }
};

/// A linear system with its constraints in the units of the stiffness:
/// [[K, s B^T], [s B, 0]] (x, y / s) = (f, 0) with s the mean of |diag K|.
///
/// Without s, K of 1e11 beside B of 1 would leave no correct digit in the residual of the constraints.
/// Holds a reference: the system must outlive it.
class ScaledSystem {
 public:
  explicit ScaledSystem(const LinearSystem& system);

  const LinearSystem& system() const { return system_; }
  int rows() const;
  double scale() const { return scale_; }

  /// (f, 0).
  Eigen::VectorXd right_side() const;
  /// Right side minus matrix times z, sums kept in extended precision.
  Eigen::VectorXd residual(const Eigen::VectorXd& z) const;
  /// ||residual(z)|| / ||f||, and 0 or infinity if f is zero.
  double relative_residual(const Eigen::VectorXd& z) const;
  /// The relative residual that rounding z to double precision alone can cause.
  /// @source  Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 7.1
  double rounding_level(const Eigen::VectorXd& z) const;

  Eigen::VectorXd unknowns(const Eigen::VectorXd& z) const;
  /// Multipliers of the unscaled system.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& z) const;
  Eigen::VectorXd join(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers) const;

 private:
  const LinearSystem& system_;
  double scale_ = 1;
};

/// Entries on and above the diagonal.
/// @throws Error unsupported  if Index cannot count them
template <class Index>
CompressedRows<Index> upper_triangle(const ScaledSystem& system);

/// All entries.
CompressedRows<std::int64_t> full_matrix(const ScaledSystem& system);

}  // namespace isopatch::solvers
