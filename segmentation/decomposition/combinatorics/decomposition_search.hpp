#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/search_options.hpp"
#include "segmentation/decomposition/combinatorics/search_oracle.hpp"

namespace isopatch::segmentation {

/// The cuts that were made, cell by cell. Node 0 is the whole.
struct CutTree {
  struct Node {
    SearchCell cell;
    std::optional<CuttingLoop> loop;  ///< that the cell is cut along
    std::vector<int> pieces;          ///< nodes; none for a cell that stays
    std::optional<BaseSolid> base;    ///< of a cell that stays and is accepted as one
  };
  std::vector<Node> nodes;
  std::vector<int> unfinished;  ///< nodes that stay and are no accepted base solids
  int hexahedra = 0;            ///< that the templates make of the others
  int evaluations = 0;          ///< cuts tried by the oracle
  int refusals = 0;             ///< of them
  double cost = 0;              ///< hexahedra with penalties; 1000 for each unfinished cell
  bool complete() const { return unfinished.empty(); }
};

/// Cuts a cell down to base solids: a beam search over states, which are sets of cells.
///
/// A round cuts the worst open cell of every state in its best few ways; of all that come of it the `beam`
/// best are kept, by hexahedra estimated and penalties, and of equal ones one. Non-convex edges go first.
/// Loops are ranked without the oracle, which is asked for the best only, and never twice for the same cell.
/// The same arguments give the same tree.
/// @throws Error not_three_connected  a cell whose graph is not;  invalid_argument  an oracle without `cut`;
/// what the oracle
///               throws
CutTree search_cuts(const SearchCell& cell, const SearchOracle& oracle, const SearchOptions& options = {});

/// The same, and the next best ways to the end that the search comes upon, `alternatives` of them at most,
/// cheapest first.
std::vector<CutTree> search_several(const SearchCell& cell, const SearchOracle& oracle,
                                    const SearchOptions& options = {});

}  // namespace isopatch::segmentation
