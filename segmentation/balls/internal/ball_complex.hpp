#pragma once

#include <array>

#include "geometry/brep/cell_complex.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Splines over the unit square beside the sides of a cube (`cube_sides`), m: u from a side's first corner to
/// its second, v from its first to its last. Their normals point outwards; neighbours share the points of
/// their borders.
using OuterSides = std::array<geometry::NurbsSurface, 6>;

/// A hexahedron of straight edges around a point and one between it and each outer side. All outer sides are
/// of the source's face 0.
geometry::CellComplex ball_complex(const OuterSides& outer, const Eigen::Vector3d& centre);

}  // namespace isopatch::segmentation
