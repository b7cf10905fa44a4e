#pragma once

#include "segmentation/decomposition/combinatorics/origin.hpp"

namespace isopatch::segmentation {

/// Cuts a cell along a loop: the pieces to its left and right, the faces extended that the loop extends.
///
/// The new face is the last in a piece unless it continues others. Vertices that an extension leaves with
/// degree two are gone, their two edges are one with two stretches.
/// @throws Error invalid_argument  a loop that does not exist on the cell, passes a place twice, or has
/// nothing on one side; an
///                                 extension along an auxiliary edge, or after which a face is no disc
/// @cost  O(size of the graph)
CutPieces cut_along(const CellGraph& graph, const CuttingLoop& loop);

}  // namespace isopatch::segmentation
