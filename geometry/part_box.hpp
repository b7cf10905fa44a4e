#pragma once

#include <Eigen/Geometry>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// The smallest box around a part, edges along the axes: of the part itself and not of its control points,
/// which lie outside of curved patches.
/// @return  model units; to about 1e-12 of the size for faces that bulge no more than once between the points
/// of a grid of 2 degree + 1 points per element
/// @cost  the grid on every boundary face, and some hundred points for each of the few that may reach
/// furthest
Eigen::AlignedBox3d part_box(const MultiPatch& model);

}  // namespace isopatch::geometry
