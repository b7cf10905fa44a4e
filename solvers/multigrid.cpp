#include "solvers/multigrid.hpp"

namespace isopatch::solvers {

Multigrid::Multigrid(std::vector<MultigridLevel> levels, LinearOperator coarse_inverse,
                     const MultigridOptions& options)
    : levels_(std::move(levels)), coarse_inverse_(std::move(coarse_inverse)), options_(options) {
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l)
    largest_.push_back(largest_eigenvalue(levels_[l].product, levels_[l].smoother, levels_[l].rows,
                                          options_.eigenvalue_steps));
}

Eigen::VectorXd Multigrid::apply(const Eigen::VectorXd& residual) const {
  return cycle(0, residual);
}

Eigen::VectorXd Multigrid::smooth(std::size_t level, const Eigen::VectorXd& b) const {
  // The estimate is from below, and beyond the interval the polynomial would amplify.
  const double high = 1.1 * largest_[level];
  return chebyshev(levels_[level].product, levels_[level].smoother, b,
                   {high / options_.smoothing_range, high, options_.smoothing_degree});
}

Eigen::VectorXd Multigrid::cycle(std::size_t level, const Eigen::VectorXd& b) const {
  if (level + 1 == levels_.size()) return coarse_inverse_(b);
  const MultigridLevel& here = levels_[level];
  const MultigridLevel& coarser = levels_[level + 1];
  Eigen::VectorXd x = smooth(level, b);
  x += coarser.to_finer(cycle(level + 1, coarser.from_finer(b - here.product(x))));
  x += smooth(level, b - here.product(x));
  return x;
}

}  // namespace isopatch::solvers
