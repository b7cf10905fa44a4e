#pragma once

#include <array>

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/sweeps/internal/swept_drawing.hpp"

namespace isopatch::segmentation {

/// The lowest and the highest height at which tracks are known, m; there are some.
std::array<double, 2> range_of(const Tracks& tracks);

/// The profile of a drawing where it is at a height: the same edges and regions, what is on inclined walls
/// moved along them.
Profile profile_at(const geometry::Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                   double height);

/// Quadrilaterals of the profile at a height as those of the drawing: vertices inside are moved to where they
/// are drawn.
Quadrangulation as_drawn(const geometry::Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                         Quadrangulation at_height, double height);

/// The least scaled Jacobian of the hexahedra that stand on a divided drawing, about: of its quadrilaterals
/// where walls begin and end, at floors and half-way up, each with the steepest way up beside it.
/// @cost  some milliseconds for 100 quadrilaterals
double least_over_heights(const geometry::Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                          const Quadrangulation& quads);

}  // namespace isopatch::segmentation
