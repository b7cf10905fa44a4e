#pragma once

#include <Eigen/Core>
#include <vector>

#include "solvers/chebyshev.hpp"
#include "solvers/linear_operator.hpp"
#include "solvers/multigrid_options.hpp"
#include "solvers/shared_rows.hpp"

namespace isopatch::solvers {

/// One level of a multigrid. All operators take and give consistent local vectors.
struct MultigridLevel {
  SharedRows rows;
  VectorsOperator product;     ///< A of this level
  VectorsOperator smoother;    ///< B, a symmetric positive definite approximate inverse of A's rough part
  VectorsOperator to_finer;    ///< prolongation to the level above; empty on the finest
  VectorsOperator from_finer;  ///< its transpose
};

/// One symmetric V-cycle: a preconditioner whose quality does not depend on the number of unknowns.
///
/// @source Hackbusch, Multi-Grid Methods and Applications, 1985; Adams, Brezina, Hu, Tuminaro 2003
/// (Chebyshev smoothing)
class Multigrid {
 public:
  /// @param levels          finest first; `product` and `smoother` of the coarsest are not used
  /// @param coarse_inverse  solves on the coarsest level
  /// @throws Error singular_system  if a level's product or smoother is not positive definite
  Multigrid(std::vector<MultigridLevel> levels, VectorsOperator coarse_inverse,
            const MultigridOptions& options = {});

  /// @cost  2 degree products with A and B on every level
  Eigen::VectorXd apply(const Eigen::VectorXd& residual) const;

  /// The same of each column.
  Eigen::MatrixXd apply_each(const Eigen::MatrixXd& residuals) const;

  int levels() const { return static_cast<int>(levels_.size()); }

 private:
  template <class Vectors>
  Vectors cycle(std::size_t level, const Vectors& b) const;
  ChebyshevInterval interval(std::size_t level) const;
  std::vector<MultigridLevel> levels_;
  VectorsOperator coarse_inverse_;
  std::vector<double> largest_;  ///< eigenvalue of the smoothed product, by level but the coarsest
  MultigridOptions options_;
};

}  // namespace isopatch::solvers
