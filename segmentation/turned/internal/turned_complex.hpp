#pragma once

#include "geometry/brep/cell_complex.hpp"
#include "segmentation/turned/internal/turned_drawing.hpp"

namespace isopatch::segmentation {

/// The hexahedra of a divided half profile turned in equal sectors, and of the columns along the axis, with
/// all that they share stored once. Faces on the solid's refer to them and look outwards.
/// @param sectors  4 of a whole turn, an even number of what reaches the axis in less
/// @throws Error unsupported  a place of its surface that no face of the solid has
geometry::CellComplex turned_complex(const geometry::Brep& solid, const TurnedFrame& frame,
                                     const TurnedDrawing& drawing, int sectors);

}  // namespace isopatch::segmentation
