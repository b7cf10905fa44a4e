#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// Planes about which a solid looks symmetric: across the axes, across plane faces, and half way between
/// parallel cylinders, if each plane, cylinder, cone, sphere and torus has its image with as large an area.
/// `mirrored_cells` is the proof. Those across the axes come first.
/// @cost  one triangulation, and for each candidate the square of the number of faces
std::vector<geometry::PlaneSurface> mirror_planes(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
