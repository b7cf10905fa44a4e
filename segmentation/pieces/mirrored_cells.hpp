#pragma once

#include <functional>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// Cuts a solid in its plane of symmetry, divides what lies on one side, and adds its image.
/// @param cells_of  divides a half; all curves and surfaces of its cells are new ones
/// @throws Error invalid_argument  the solid is not symmetric about the plane: names a face, or it does not
/// meet the plane
/// @throws what `cells_of` throws
geometry::CellComplex mirrored_cells(
    const geometry::Brep& solid, const geometry::PlaneSurface& plane,
    const std::function<geometry::CellComplex(const geometry::Brep& half)>& cells_of);

}  // namespace isopatch::segmentation
