#pragma once

#include <vector>

#include "iga/coupling/row_numbering.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/shared_rows.hpp"

namespace isopatch::iga {

/// The element layers of a patch that one process integrates, as shares: from `begin` to `end` of the way
/// along direction 3.
struct PatchShare {
  int patch = 0;
  double begin = 0;
  double end = 1;
  bool couples = true;  ///< also what ties the patch where its sides do not match others

  bool is_empty() const { return begin == end; }
};

/// The patches, or shares of patches, that each process integrates: increasing, each patch at most once a
/// process. The shares of a patch follow each other in the order of the processes; the one with the first is
/// its *primary* process. Empty shares, of what has nothing to integrate there but needs the patch's rows,
/// may be anywhere.
using Distribution = std::vector<std::vector<PatchShare>>;

/// Spreads patches over processes so that each has about as many operations. Whole patches where that is
/// balanced within a tenth, neighbours in number first, else patches are cut between layers of elements.
///
/// There may be processes with nothing if there are more of them than layers.
/// @cost  O(patches log patches)
Distribution distribute(const std::vector<PatchSpace>& spaces, int processes);

/// The element layers that a process integrates, of spaces on the same patches: those of `distribute` or
/// coarser ones.
std::vector<PatchLayers> layers_of(const Distribution& distribution, const std::vector<PatchSpace>& spaces,
                                   int process);

/// Of every patch: the processes that have a share of it; the primary one first, those with empty shares
/// last, else increasing.
std::vector<std::vector<int>> processes_of_patches(const Distribution& distribution, int patches);

/// Of every block row of a whole system: the processes that have a share of a patch with it, increasing.
/// @param whole       the rows of the whole system
/// @param first_node  of each patch, and the number of nodes at the end
/// @cost  O(nodes)
std::vector<std::vector<int>> processes_of_rows(const RowNumbering& whole, const std::vector<int>& first_node,
                                                const Distribution& distribution);

/// The rows that this process keeps of a whole system: all of every patch of which it has a share, so that
/// transfers and smoothers of whole patches need no other process.
struct LocalRows {
  solvers::SharedRows rows;
  RowNumbering numbering;  ///< -1 for nodes without a local row
};
/// @param whole       the rows of the whole system
/// @param first_node  of each patch, and the number of nodes at the end
/// @cost  O(nodes)
LocalRows local_rows(const RowNumbering& whole, const std::vector<int>& first_node,
                     const Distribution& distribution, const solvers::Processes& processes);

}  // namespace isopatch::iga
