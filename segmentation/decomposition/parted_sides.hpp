#pragma once

#include <vector>

#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// A side of a cell that is several faces, since its neighbours are smaller.
struct PartedSide {
  geometry::CellId cell;
  std::vector<EdgeId> inside;  ///< edges between those faces
};

/// Where cells meet in parts of sides: the T-joints.
std::vector<PartedSide> parted_sides(const CellShapes& shapes, const SideOptions& options = {});

}  // namespace isopatch::segmentation
