#include "solvers/multigrid.hpp"

namespace isopatch::solvers {
namespace {

Eigen::VectorXd applied(const VectorsOperator& map, const Eigen::VectorXd& x) {
  return map(x);
}
Eigen::MatrixXd applied(const VectorsOperator& map, const Eigen::MatrixXd& x) {
  return map.of_each(x);
}

Eigen::VectorXd smoothed(const MultigridLevel& level, const Eigen::VectorXd& b,
                         const ChebyshevInterval& interval) {
  return chebyshev(level.product, level.smoother, b, interval);
}
Eigen::MatrixXd smoothed(const MultigridLevel& level, const Eigen::MatrixXd& b,
                         const ChebyshevInterval& interval) {
  return chebyshev_of_each(level.product, level.smoother, b, interval);
}

}  // namespace

Multigrid::Multigrid(std::vector<MultigridLevel> levels, VectorsOperator coarse_inverse,
                     const MultigridOptions& options)
    : levels_(std::move(levels)), coarse_inverse_(std::move(coarse_inverse)), options_(options) {
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l)
    largest_.push_back(largest_eigenvalue(levels_[l].product, levels_[l].smoother, levels_[l].rows,
                                          options_.eigenvalue_steps));
}

Eigen::VectorXd Multigrid::apply(const Eigen::VectorXd& residual) const {
  return cycle(0, residual);
}

Eigen::MatrixXd Multigrid::apply_each(const Eigen::MatrixXd& residuals) const {
  return residuals.cols() == 1 ? Eigen::MatrixXd(apply(residuals.col(0))) : cycle(0, residuals);
}

ChebyshevInterval Multigrid::interval(std::size_t level) const {
  // The estimate is from below, and beyond the interval the polynomial would amplify.
  const double high = 1.1 * largest_[level];
  return {high / options_.smoothing_range, high, options_.smoothing_degree};
}

template <class Vectors>
Vectors Multigrid::cycle(std::size_t level, const Vectors& b) const {
  if (level + 1 == levels_.size()) return applied(coarse_inverse_, b);
  const MultigridLevel& here = levels_[level];
  const MultigridLevel& coarser = levels_[level + 1];
  Vectors x = smoothed(here, b, interval(level));
  const Vectors rest = b - applied(here.product, x);
  x += applied(coarser.to_finer, cycle(level + 1, applied(coarser.from_finer, rest)));
  const Vectors left = b - applied(here.product, x);
  x += smoothed(here, left, interval(level));
  return x;
}

}  // namespace isopatch::solvers
