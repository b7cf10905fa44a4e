#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "solvers/linear_system.hpp"

namespace isopatch::solvers {

/// Entries of a scalar matrix, or one process' share of them: entries of one place are summed.
struct MatrixEntries {
  std::vector<int> rows;
  std::vector<int> columns;
  std::vector<double> values;
  std::int64_t bytes() const {
    return static_cast<std::int64_t>((rows.size() + columns.size()) * sizeof(int) +
                                     values.size() * sizeof(double));
  }
};

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
/// [[K, s B^T], [s B, 0]] (x, y / s) = (f, s g) with s the mean of |diag K|, rounded to a power of 2 so that
/// products with it are exact.
///
/// Without s, K of 1e11 beside B of 1 would leave no correct digit in the residual of the constraints.
/// Spread over processes, all vectors z are consistent local ones, (local K rows, then local multipliers),
/// and all processes must call the same functions. Holds a reference: the system must outlive it.
class ScaledSystem {
 public:
  explicit ScaledSystem(const LinearSystem& system) : ScaledSystem(system, system.load) {}
  /// With another f, or f and g.
  ScaledSystem(const LinearSystem& system, const Eigen::VectorXd& load);

  const LinearSystem& system() const { return system_; }
  /// f, or f and s g.
  const Eigen::VectorXd& load() const { return load_; }
  /// Number of K's scalar rows and multipliers on this process.
  int rows() const;
  double scale() const { return scale_; }

  /// Length of a vector of the whole system.
  double norm(const Eigen::VectorXd& z) const;
  double load_norm() const;

  /// The right side (f, s g).
  Eigen::VectorXd right_side() const;
  /// Right side minus matrix times z, sums kept in extended precision.
  Eigen::VectorXd residual(const Eigen::VectorXd& z) const;
  /// ||residual(z)|| / ||(f, s g)||, and 0 or infinity if both are zero.
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
  Eigen::VectorXd load_;
  double scale_ = 1;
};

/// One system with several right sides, in turn. Never empty.
using ScaledSystems = std::vector<ScaledSystem>;

/// Rows of the whole system, K's and then the multipliers'.
std::int64_t global_rows(const ScaledSystem& system);

/// This process' entries on and above the diagonal in the rows of the whole system, counted from `first`.
/// @throws Error unsupported  for more than 2^31 - 2 rows
MatrixEntries upper_entries(const ScaledSystem& system, int first);

/// All entries, on one process.
CompressedRows<std::int64_t> full_matrix(const ScaledSystem& system);

}  // namespace isopatch::solvers
