#pragma once

#include <array>
#include <vector>

#include "geometry/patch_face.hpp"

namespace isopatch::geometry {

/// One of the twelve edges of a patch: it runs along `along`, at the low or high ends of the other two
/// directions.
struct PatchEdge {
  int along = 0;                              ///< 0 .. 2
  std::array<bool, 2> high = {false, false};  ///< at the high end of the other two directions, increasing
  auto operator<=>(const PatchEdge&) const = default;
};

/// All twelve, ordered by direction.
std::array<PatchEdge, 12> all_edges();

/// Indices of the control points on an edge, in the order of its direction.
std::vector<int> edge_control_points(const std::array<int, 3>& sizes, const PatchEdge& edge);

/// Whether an edge is one point: its control points lie within `tolerance` of its first.
/// @param tolerance  model units
bool is_collapsed(const NurbsVolume& volume, const PatchEdge& edge, double tolerance);

/// Whether a side is collapsed along one of its directions: every line of its control points along that
/// direction is one point, so the side is a curve (or a point) and its boundary lines along it coincide.
/// @param tangent_direction  a direction of the volume, one of tangents(side)
/// @param tolerance          model units
/// @throws Error invalid_argument if the side does not contain the direction
bool is_collapsed(const NurbsVolume& volume, Side side, int tangent_direction, double tolerance);

/// Whether a side has no area because it is collapsed along one or both of its directions.
/// @param tolerance  model units
bool is_collapsed(const NurbsVolume& volume, Side side, double tolerance);

}  // namespace isopatch::geometry
