#pragma once

#include <string>
#include <vector>

#include "segmentation/decomposition/chords.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"

namespace isopatch::segmentation {

/// Cuts of one cell, each made by itself, or why there are none.
struct ClosingCuts {
  std::vector<CutCell> cuts;
  std::string refusal = {};  ///< of the last cut tried, in words
};

/// Ways to carry chords on through the cell on whose sides they lie. A hexahedron that a chord divides from
/// one edge to the opposite one is cut as a sheet through four opposite edges; else by loops of up to five
/// places through the chord, by the planes of the cuts that made it, and by the one across its side.
/// @param chords  of the cell; the ways through the first that has any are given
/// @param most  cuts tried along loops
/// @cost  cuts, each with a copy of the complex
ClosingCuts closing_cuts(const CellShapes& shapes, geometry::CellId cell, const CellSides& sides,
                         const std::vector<Chord>& chords, const CutOptions& options, int most = 12);

/// Ways to cut a cell through a vertex with more than three edges: by the planes of two of them each.
ClosingCuts cuts_at_vertices(const CellShapes& shapes, geometry::CellId cell, const CellSides& sides,
                             const CutOptions& options);

}  // namespace isopatch::segmentation
