#pragma once

#include "geometry/brep/cell_complex.hpp"
#include "segmentation/sweeps/internal/layers.hpp"
#include "segmentation/sweeps/internal/rounding.hpp"

namespace isopatch::segmentation {

/// The hexahedra of columns, with all that they share stored once. Faces on the solid's refer to them and
/// look outwards.
/// @param rounding  where they are not straight up and level
/// @throws Error unsupported  a curve that cannot be cut so, a wall that no face of the solid has
geometry::CellComplex column_complex(const geometry::Brep& solid, const SweepFrame& frame,
                                     const Quadrangulation& quads, const MovingDrawing& moving,
                                     const Layers& layers, const Rounding& rounding = {});

}  // namespace isopatch::segmentation
