#pragma once

#include "segmentation/sweeps/internal/layers.hpp"

namespace isopatch::segmentation {

/// Volume of all columns together, m^3, by the areas of their quadrilaterals at the heights of levels and
/// half way between them: what the hexahedra have, without making any.
/// @cost  a quadrature of each edge of the drawing at each of these heights
double column_volume(const SweepFrame& frame, const Quadrangulation& quads, const MovingDrawing& moving,
                     const Layers& layers);

/// What is seen along a direction that is not the stack's looks like one and leaves something out.
/// @throws Error unsupported  the columns have not the solid's volume to 1e-5
void require_whole(const geometry::Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
                   const MovingDrawing& moving, const Layers& layers);

}  // namespace isopatch::segmentation
