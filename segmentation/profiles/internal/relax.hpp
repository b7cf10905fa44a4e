#pragma once

#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/cell_shape.hpp"
#include "segmentation/profiles/internal/curve.hpp"
#include "segmentation/profiles/internal/window.hpp"

namespace isopatch::segmentation::planar {

/// Moves nodes inside and cuts along their curves to where the cells around them cost less, one after the
/// other.
/// @param nodes those that may be moved; vertices of the profile stay
/// @param rounds how often; the steps get shorter
/// @return what has been gained
/// @cost some 20 microseconds a node and round
double relax(const ShapeRules& rules, const std::vector<Curve>& curves, CellMesh& mesh,
             const Neighbours& neighbours, const std::vector<int>& nodes, int rounds);

}  // namespace isopatch::segmentation::planar
