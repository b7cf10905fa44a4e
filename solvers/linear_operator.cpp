#include "solvers/linear_operator.hpp"

namespace isopatch::solvers {

Eigen::MatrixXd VectorsOperator::of_each(const Eigen::MatrixXd& x) const {
  if (several_ && x.cols() > 1) return several_(x);
  Eigen::MatrixXd result;
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const Eigen::VectorXd one = one_(x.col(i));
    if (i == 0) result.resize(one.size(), x.cols());
    result.col(i) = one;
  }
  return result;
}

}  // namespace isopatch::solvers
