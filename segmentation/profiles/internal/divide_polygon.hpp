#pragma once

#include <optional>
#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/cell_shape.hpp"
#include "segmentation/profiles/internal/curve.hpp"

namespace isopatch::segmentation::planar {

/// A corner of a polygon, counterclockwise, with the way to the next one. The polygon may run along a line
/// and back, where a hole or a node inside hangs on it.
struct Place {
  int node = -1;
  bool optional = false;  ///< inside a piece of a curve that need not be cut here
  Side link;              ///< to the next place, from the last to the first
};

struct Division {
  double cost = refused;
  std::vector<Cell> cells;
};

/// The cheapest division of a polygon by chords between its places, exact: by recursion over the chords. All
/// cells are valid, so that the division is one in the plane.
/// @param places at least one not optional
/// @param bound what it must cost less than
/// @param triangles whether triangles are allowed
/// @return nothing if there is none
/// @cost fourth power of the places, some milliseconds for 40
std::optional<Division> divide_polygon(const ShapeRules& rules, const std::vector<Curve>& curves,
                                       const std::vector<Node>& nodes, std::vector<Place> places, int region,
                                       double bound, bool triangles);

}  // namespace isopatch::segmentation::planar
