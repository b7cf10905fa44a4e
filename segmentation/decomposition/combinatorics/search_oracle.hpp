#pragma once

#include <functional>
#include <string>
#include <vector>

#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/loop_cost.hpp"

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

/// How far a search is.
struct SearchRound {
  int cuts = 0;  ///< made on the way to the best state
  int open = 0;  ///< cells of it that have to be cut
};

/// What the search for cuts asks of the geometry.
struct SearchOracle {
  /// Tries one cut. The answer must depend on its arguments alone: it is remembered.
  std::function<CutAnswer(const SearchCell&, const CuttingLoop&)> cut;
  /// More loops to consider for a cell, in front of all others where costs are equal: carriers of faces,
  /// planes of symmetry. May be empty.
  std::function<std::vector<CuttingLoop>(const SearchCell&)> propose;
  /// Whether a cell with the graph of a base solid may stay as it is; by default one without non-convex
  /// edges. Of simple solids, which may be cut further as well, by default none.
  std::function<bool(const SearchCell&, const BaseSolid&)> accepts;
  /// Asked before every round: without a yes the search ends with the best state so far. May be empty.
  std::function<bool(const SearchRound&)> goes_on;
};

/// An oracle that never says no to a valid loop: the pieces of `cut_along`, their flat edges contracted.
/// Points of auxiliary vertices are the midpoints of their edges.
SearchOracle combinatorial_oracle();

}  // namespace isopatch::segmentation
