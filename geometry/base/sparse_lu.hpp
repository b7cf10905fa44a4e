#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <optional>

namespace isopatch {

// Eigen's templates for these take seconds to compile, so they are compiled here, once.

/// LU factors of a sparse square matrix with partial pivoting.
class SparseLu {
 public:
  /// @param matrix  (n, n), compressed or not
  explicit SparseLu(const Eigen::SparseMatrix<double>& matrix);
  ~SparseLu();
  SparseLu(SparseLu&&) noexcept;

  /// Whether a pivot was 0: nothing can be solved then.
  bool is_singular() const;
  /// matrix * x = right. (n, k)
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// Solves matrix * x = right by such factors; nothing if the matrix is singular.
/// @param right   (n, k)
/// @return (n, k)
std::optional<Eigen::MatrixXd> solve_by_lu(const Eigen::SparseMatrix<double>& matrix,
                                           const Eigen::MatrixXd& right);

}  // namespace isopatch
