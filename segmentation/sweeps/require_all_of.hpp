#pragma once

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// That the cells have the solid's volume, to 1e-5 of it.
///
/// @throws Error unsupported  how much is missing
/// @throws Error              as `cell_solids`
/// @cost  a solid of the CAD kernel for each cell
void require_all_of(const geometry::Brep& solid, const geometry::CellComplex& cells);

}  // namespace isopatch::segmentation
