#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/splines/transfer.hpp"
#include "iga/multigrid/level.hpp"

namespace isopatch::iga {

/// Prolongation and restriction between two neighbouring levels: knot insertion and degree elevation of the
/// coefficients (times their weights where both levels are rational), direction by direction in each patch.
/// Both levels must outlive it.
class LevelTransfer {
 public:
  LevelTransfer(const Level& coarse, const Level& fine);

  /// Coefficients in the finer level. Takes and gives consistent local vectors. (3 rows)
  Eigen::VectorXd to_finer(const Eigen::VectorXd& x) const;
  /// The transpose of `to_finer`: nodal forces of the finer level as those of the coarser. (3 rows)
  Eigen::VectorXd from_finer(const Eigen::VectorXd& force) const;

 private:
  using Directions = std::array<geometry::TransferMatrix, 3>;
  const Level* coarse_;
  const Level* fine_;
  std::vector<Directions> matrices_;    // per patch
  std::vector<Directions> transposed_;  // per patch
  Eigen::VectorXd share_;               // of every local fine row: 1 / nodes that belong to it
};

}  // namespace isopatch::iga
