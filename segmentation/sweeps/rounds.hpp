#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// Rounds that keep a solid from being a stack.
struct Rounds {
  std::vector<FaceId> faces;  ///< empty if it is a stack, or other faces are in the way too
  double largest_radius = 0;  ///< m
};

/// Of the direction with the fewest. A round is a curved face that continues its neighbours without an edge
/// on two sides at least.
/// @param largest_radius  m, of what counts as a round
Rounds rounds_in_the_way(const geometry::Brep& solid, double largest_radius);

}  // namespace isopatch::segmentation
