#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace isopatch {

/// Cholesky factors of a sparse symmetric positive definite matrix.
class SparseCholesky {
 public:
  /// @param matrix  (n, n), both triangles
  explicit SparseCholesky(const Eigen::SparseMatrix<double>& matrix);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;

  /// False where a pivot was not above 0: nothing can be solved then.
  bool is_positive_definite() const;
  /// matrix * x = right. (n)
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace isopatch
