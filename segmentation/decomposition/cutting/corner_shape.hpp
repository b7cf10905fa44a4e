#pragma once

#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// Whether all corners of a cell where three edges meet can be corners of patches. One cannot where a side
/// has an angle of 180 degrees or more, or where the corner points inwards: the patch would be folded there.
bool corners_open(const CellShapes& shapes, const CellSides& sides);

}  // namespace isopatch::segmentation
