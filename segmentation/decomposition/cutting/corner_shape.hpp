#pragma once

#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// The volume that unit vectors along the three edges of a corner span, in [-1, 1]: a hexahedron's Jacobian
/// has its sign there. Where it is not above 0, a side has a corner of 180 degrees or more, or the corner
/// points inwards, and no patch follows it.
/// @param vertex  of the sides' graph, where three edges meet
double corner_volume(const CellShapes& shapes, const CellSides& sides, VertexId vertex);

/// The corner of the least volume among those where three edges meet; -1 if there is none.
VertexId sharpest_corner(const CellShapes& shapes, const CellSides& sides);

/// Corners of less volume fold a patch, or let it degenerate.
constexpr double least_corner_volume = 1e-3;

/// Whether all corners of a cell where three edges meet can be corners of patches.
bool corners_open(const CellShapes& shapes, const CellSides& sides);

}  // namespace isopatch::segmentation
