#pragma once

#include <array>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/sweeps/internal/layers.hpp"
#include "segmentation/sweeps/internal/rounding.hpp"

namespace isopatch::segmentation {

/// Moves levels out of ranges of heights wherever they are no floors and no wall changes there: a blind
/// bore's bottom divides all columns around it, and these may bend away from what else is at its height.
/// @param kept_free  ranges of heights, low and high, m
/// @return  where the vertices of such levels are, and curves that move with them
Rounding bent_levels(const geometry::Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
                     const MovingDrawing& moving, const Layers& layers,
                     const std::vector<std::array<double, 2>>& kept_free);

}  // namespace isopatch::segmentation
