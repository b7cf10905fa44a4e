#pragma once

#include <vector>

#include "segmentation/decomposition/combinatorics/internal/loop_walk.hpp"
#include "segmentation/decomposition/combinatorics/internal/planar_map.hpp"

namespace isopatch::segmentation {

/// The vertices of a sphere as places.
PlaceGraph vertex_places(const PlanarMap& map, const Darts& around);

/// The two pieces of a cut along a valid loop of vertices, to its left and its right; vertices keep their
/// order.
struct MapPieces {
  PlanarMap left, right;
};
MapPieces cut(const PlanarMap& map, const Darts& around, const std::vector<int>& loop);

}  // namespace isopatch::segmentation
