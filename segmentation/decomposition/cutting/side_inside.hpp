#pragma once

#include <set>
#include <vector>

#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// What lies inside a side that is several faces.
struct SideInside {
  std::set<VertexId> outline;  ///< vertices around the side
  std::vector<EdgeId> edges;   ///< between two of its faces
};

/// @param side  faces of one cell that continue each other
SideInside side_inside(const geometry::CellComplex& complex, const std::vector<geometry::CellFaceUse>& side);

}  // namespace isopatch::segmentation
