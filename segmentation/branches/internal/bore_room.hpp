#pragma once

#include <array>
#include <vector>

#include "segmentation/branches/internal/cross_bores.hpp"
#include "segmentation/sweeps/stack.hpp"

namespace isopatch::segmentation {

/// How a stack is to be divided, so that every bore across it begins within one side.
struct BoreRoom {
  std::vector<Line> lines;                       ///< of its drawing, m
  std::vector<double> heights;                   ///< along it, m
  std::vector<std::array<double, 2>> kept_free;  ///< of bores and what is beside them, heights along it, m
};

/// How far the planes at bores' floors go.
enum class FloorLines {
  through_all,     ///< the whole stack
  between_planes,  ///< to the planes beside the bore: leaves more freedom to what is beyond
  own_columns,     ///< no further than the sides of the bore's own column (see `own_columns`)
};

/// Planes between bores, along the stack and across it, near to those that have much room; at floors.
/// @param blank  the stack without the bores
BoreRoom bore_room(const geometry::Brep& solid, const geometry::Brep& blank, const SweepFrame& frame,
                   const std::vector<CrossBore>& bores, FloorLines floors);

}  // namespace isopatch::segmentation
