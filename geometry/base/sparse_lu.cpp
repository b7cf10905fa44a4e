#include "geometry/base/sparse_lu.hpp"

#include <Eigen/SparseLU>

namespace isopatch {

struct SparseLu::Factors {
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
};

SparseLu::SparseLu(const Eigen::SparseMatrix<double>& matrix) : factors_(std::make_unique<Factors>()) {
  factors_->lu.compute(matrix);
}

SparseLu::~SparseLu() = default;
SparseLu::SparseLu(SparseLu&&) noexcept = default;

bool SparseLu::is_singular() const {
  return factors_->lu.info() != Eigen::Success;
}

Eigen::MatrixXd SparseLu::solve(const Eigen::MatrixXd& right) const {
  return factors_->lu.solve(right);
}

std::optional<Eigen::MatrixXd> solve_by_lu(const Eigen::SparseMatrix<double>& matrix,
                                           const Eigen::MatrixXd& right) {
  const SparseLu factors(matrix);
  if (factors.is_singular()) return std::nullopt;
  return factors.solve(right);
}

}  // namespace isopatch
