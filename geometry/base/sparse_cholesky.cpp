#include "geometry/base/sparse_cholesky.hpp"

#include <Eigen/SparseCholesky>

namespace isopatch {

struct SparseCholesky::Factors {
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> llt;
};

SparseCholesky::SparseCholesky(const Eigen::SparseMatrix<double>& matrix)
    : factors_(std::make_unique<Factors>()) {
  factors_->llt.compute(matrix);
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;

bool SparseCholesky::is_positive_definite() const {
  return factors_->llt.info() == Eigen::Success;
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& right) const {
  return factors_->llt.solve(right);
}

}  // namespace isopatch
