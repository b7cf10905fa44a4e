#pragma once

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"

namespace isopatch::segmentation {

/// By how much a cut along a valid loop without extensions changes the sum over faces of |corners - 4| and
/// over vertices of |degree - 3|: what `excess` of both pieces is more than that of the cell.
/// @cost O(places times degree), without making the cut
int excess_change(const CellGraph& graph, const CellIncidence& incidence, const CuttingLoop& loop);

/// The sum over faces of |corners - 4| and over vertices of |degree - 3|; 0 for hexahedra alone.
int excess(const CellGraph& graph);

}  // namespace isopatch::segmentation
