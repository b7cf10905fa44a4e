#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// Planes worth cutting a solid by: those of plane faces at concave edges, extended, and those across
/// straight edges where a round begins. Those of circles where
/// one round face goes on in another, as a pipe in its bend. Each once; only such that have some of the solid
/// on both sides.
std::vector<geometry::PlaneSurface> cut_planes(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
