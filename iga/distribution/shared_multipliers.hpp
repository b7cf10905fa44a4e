#pragma once

#include <vector>

#include "iga/coupling/supported_system.hpp"
#include "iga/distribution/distribution.hpp"

namespace isopatch::iga {

/// A process's share of the constraint matrix B: B is the sum of all shares.
struct SharedMultipliers {
  solvers::ConstraintMatrix matrix;                ///< (local multipliers, 3 local nodes)
  std::vector<std::vector<int>> processes_of_row;  ///< of the whole B, increasing; empty on one process
};

/// Spreads `multiplier_matrix` over processes: each of a multiplier's two nodes belongs to the primary
/// process of its patch, which has the entry of that node. A multiplier that ties patches of different
/// processes is shared.
///
/// @param local  from a numbering with one row per node
/// @throws Error as multiplier_matrix
/// @cost   O(nodes + multipliers)
SharedMultipliers shared_multipliers(const std::vector<MultiplierRow>& rows, const LocalRows& local,
                                     const std::vector<int>& first_node, const Distribution& distribution);

}  // namespace isopatch::iga
