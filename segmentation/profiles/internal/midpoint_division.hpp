#pragma once

#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/curve.hpp"

namespace isopatch::segmentation::planar {

/// Each triangle as three quadrilaterals and each quadrilateral as four, around its middle and the middles of
/// its sides.
CellMesh midpoint_division(const std::vector<Curve>& curves, const CellMesh& mesh);

}  // namespace isopatch::segmentation::planar
