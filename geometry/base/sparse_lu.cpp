#include "geometry/base/sparse_lu.hpp"

#include <Eigen/SparseLU>

namespace isopatch {

std::optional<Eigen::MatrixXd> solve_by_lu(const Eigen::SparseMatrix<double>& matrix,
                                           const Eigen::MatrixXd& right) {
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) return std::nullopt;
  return Eigen::MatrixXd(factors.solve(right));
}

}  // namespace isopatch
