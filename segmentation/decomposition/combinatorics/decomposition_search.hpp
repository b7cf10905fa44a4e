#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/loop_cost.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"

namespace isopatch::segmentation {

/// A cell as the search sees it.
struct SearchCell {
  CellGraph graph;        ///< of its sides, 3-connected
  CellGeometry geometry;  ///< as far as known
  int handle = -1;        ///< the caller's own, handed back with the cell
};

/// What came of a cut: pieces, or a refusal with its reason. More than two pieces are welcome.
struct CutAnswer {
  std::vector<SearchCell> pieces;
  std::string refusal;  ///< in words; empty if there are pieces
  double penalty = 0;   ///< in hexahedra: what is bad about the pieces
};

/// What geometry is asked.
struct SearchOracle {
  /// Tries one cut. The answer must depend on its arguments alone: it is remembered.
  std::function<CutAnswer(const SearchCell&, const CuttingLoop&)> cut;
  /// More loops to consider for a cell, in front of all others where costs are equal: carriers of faces,
  /// planes of symmetry. May be empty.
  std::function<std::vector<CuttingLoop>(const SearchCell&)> propose;
  /// Whether a cell with the graph of a base solid may stay as it is; by default one without non-convex
  /// edges.
  std::function<bool(const SearchCell&, const BaseSolid&)> accepts;
};

/// An oracle that never says no to a valid loop: the pieces of `cut_along`, their flat edges contracted.
/// Points of auxiliary vertices are the midpoints of their edges.
SearchOracle combinatorial_oracle();

struct SearchOptions {
  int beam = 8;      ///< states kept after each round; range 1 .. 10000
  int branches = 4;  ///< cuts of one cell that are followed from a state; range 1 .. 1000
  int evaluations =
      2000;            ///< of cuts by the oracle, after which the best state is finished greedily; range 1 ..
  int refusals = 40;   ///< of one cell, after which it stays as it is; range 1 ..
  int max_length = 7;  ///< of a loop; range 3 .. 1000
  int considered =
      400;  ///< loops of a cell whose pieces are looked at before the oracle is asked; range 1 ..
  CostOptions cost;
};
/// @throws Error invalid_argument  naming field, value and range
void validate(const SearchOptions& options);

/// The cuts that were made, cell by cell. Node 0 is the whole.
struct CutTree {
  struct Node {
    SearchCell cell;
    std::optional<CuttingLoop> loop;  ///< that the cell is cut along
    std::vector<int> pieces;          ///< nodes; none for a cell that stays
    std::optional<BaseSolid> base;    ///< of a cell that stays, if it is one
  };
  std::vector<Node> nodes;
  std::vector<int> unfinished;  ///< nodes that stay and are no accepted base solids
  int hexahedra = 0;            ///< that the templates make of the others
  int evaluations = 0;          ///< cuts tried by the oracle
  int refusals = 0;             ///< of them
  double cost = 0;              ///< hexahedra with penalties
  bool complete() const { return unfinished.empty(); }
};

/// Cuts a cell down to base solids: a beam search over states, which are sets of cells.
///
/// A round cuts the worst open cell of every state in its best few ways; of all that come of it the `beam`
/// best are kept, by hexahedra estimated and penalties. Non-convex edges go first. Loops are ranked without
/// the oracle, which is asked for the best only, and never twice for the same cell.
/// @throws Error not_three_connected  a cell whose graph is not
CutTree search_cuts(const SearchCell& cell, const SearchOracle& oracle, const SearchOptions& options = {});

}  // namespace isopatch::segmentation
