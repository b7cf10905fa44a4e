#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/assembly/mortar_constraints.hpp"
#include "iga/multigrid/level.hpp"
#include "iga/problem/problem.hpp"
#include "solvers/multigrid.hpp"

namespace isopatch::iga {

struct ElasticityMultigridOptions {
  solvers::MultigridOptions smoothing = {};
  int points = 0;                   ///< Gauss points per element and direction; 0: `smoothing_points`
  int coarsest_dofs = 2000;         ///< coarsen until there are no more than these, if that can be
  int coarsest_curved_dofs = 5000;  ///< the same for one element of degree 2 a patch
  /// Faces that do not match and have multipliers; empty where Nitsche's method couples them.
  MortarTies mortar = {};
};

/// The multigrid preconditioner of an elasticity problem coupled by elimination.
///
/// Levels: half the elements per direction each time, then degree 2 and 1, down to a matrix that is
/// factorized; all products but the finest and that one without a matrix. The smoother is a Chebyshev
/// polynomial in FastDiagonalization.
class ElasticityMultigrid {
 public:
  /// @param finest   the solution space; must outlive the multigrid, as must `problem`
  /// @param frames   of the finest level's global nodes
  /// @param product  of the finest level if a matrix is at hand. Empty: an operator, which for smoothing has
  ///                 `smoothing_points` even where the map of a patch asks for more, unless
  ///                 `options.points` says how many: of the products of an iteration all but one smooth
  /// @throws Error singular_system  if a level is not positive definite
  ElasticityMultigrid(const ElasticityProblem& problem, const Level& finest,
                      const std::vector<SupportFrame>& frames, const Distribution& distribution,
                      const solvers::Processes& processes, const solvers::VectorsOperator& product,
                      const ElasticityMultigridOptions& options, const Progress& progress);
  ~ElasticityMultigrid();
  ElasticityMultigrid(ElasticityMultigrid&&) noexcept;

  /// One V-cycle on consistent local vectors of unknowns. (3 rows)
  Eigen::VectorXd apply(const Eigen::VectorXd& residual) const;
  /// One V-cycle for each column; about 0.8 of the cost of one after the other.
  Eigen::MatrixXd apply_each(const Eigen::MatrixXd& residuals) const;

  int levels() const;
  std::int64_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isopatch::iga
