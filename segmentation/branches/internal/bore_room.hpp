#pragma once

#include <vector>

#include "segmentation/branches/internal/cross_bores.hpp"
#include "segmentation/sweeps/stack.hpp"

namespace isopatch::segmentation {

/// How a stack is to be divided, so that every bore across it begins within one side.
struct BoreRoom {
  std::vector<Line> lines;      ///< of its drawing, m
  std::vector<double> heights;  ///< along it, m
};

/// Planes between bores, along the stack and across it, near to those that have much room; at floors.
/// @param blank  the stack without the bores
BoreRoom bore_room(const geometry::Brep& solid, const geometry::Brep& blank, const SweepFrame& frame,
                   const std::vector<CrossBore>& bores);

}  // namespace isopatch::segmentation
