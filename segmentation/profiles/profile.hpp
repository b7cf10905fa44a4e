#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/topology/edge_use.hpp"

namespace isopatch::segmentation {

/// A curve of a drawing, from one of its vertices to another. Curves closed on themselves without a vertex
/// (whole circles) have `start` = `end` = -1.
struct ProfileEdge {
  int start = -1, end = -1;  ///< vertices of the profile
  /// Two points or more at equal steps of the curve's parameter over [0, 1], both ends included (the first
  /// and the last of a closed one are equal), enough to see its shape: a line has 2, an arc one for each 10
  /// degrees or so. Between them the curve is taken to run smoothly (cubic pieces).
  std::vector<Eigen::Vector2d> points;
};

/// A part of the plane bounded by edges. Regions share edges; they do not overlap.
struct ProfileRegion {
  /// Closed chains of uses of the profile's edges with the region to their left: the outer one,
  /// counterclockwise, first, then those of its holes, clockwise.
  std::vector<std::vector<geometry::EdgeUse>> loops;
  bool wanted = true;  ///< only wanted regions (material) are divided
};

/// A drawing in the plane, in any unit.
struct Profile {
  std::vector<Eigen::Vector2d> vertices;
  std::vector<ProfileEdge> edges;
  std::vector<ProfileRegion> regions;
};

/// That numbers are in range, all is finite, edges end in their vertices, loops are closed and run the right
/// way round.
/// @throws Error bad_format with the number of the edge or region
/// @cost linear in the points
void validate(const Profile& profile);

/// Twice the area of the polygon of a loop's points, positive if it runs counterclockwise.
double twice_area(const Profile& profile, const std::vector<geometry::EdgeUse>& loop);

}  // namespace isopatch::segmentation
