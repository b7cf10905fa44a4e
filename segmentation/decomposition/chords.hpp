#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// A T-joint: edges inside a side of a cell, straight one after the other, which divide its neighbours and
/// not the cell; from the outline of the side to its outline, or as far as they go.
struct Chord {
  int side = 0;  ///< by face of the cell's graph
  VertexId from, to;
  EdgeId first;         ///< of its edges
  bool across = false;  ///< ends on the outline
};

/// Of all sides of a cell, those that end on the outline first.
/// @cost  O(edges of sides that are several faces)
std::vector<Chord> chords_of(const CellShapes& shapes, const CellSides& sides);

/// The place of a vertex of the complex on a cell's graph; none for one inside a side.
std::optional<LoopPlace> place_of(const geometry::CellComplex& complex, const CellSides& sides,
                                  VertexId vertex);

}  // namespace isopatch::segmentation
