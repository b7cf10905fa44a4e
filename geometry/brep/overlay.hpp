#pragma once

#include <array>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/redrawn.hpp"

namespace isopatch::geometry {

/// Outlines of plane faces pushed along their normal into one plane and laid over each other: the drawing
/// that one sees who looks at them from afar.
struct Overlay {
  /// No solid but a sheet of plane faces without names, which look along the direction and share edges and
  /// vertices. Each is covered by the same outlines everywhere.
  Brep sheet;
  std::vector<std::vector<int>> covered_by;  ///< by face of the sheet: numbers of the faces laid, ascending
};

/// Edges that agree to 1e-7 of the solid's size become one; so do arcs that only the seam of a wall divides.
/// @param faces      plane, at right angles to `direction`; at least one
/// @param origin     of the plane, m
/// @param direction  unit
/// @param redrawn    edges that are not drawn as they are
/// @param lines      from point to point in the plane, m: drawn as well, inside the outlines or on them
/// @throws Error unsupported  the CAD library cannot lay them over each other
/// @cost  that of a general fuse: some milliseconds a face
Overlay overlay(const Brep& solid, const std::vector<FaceId>& faces, const Eigen::Vector3d& origin,
                const Eigen::Vector3d& direction, const Redrawn& redrawn = {},
                const std::vector<std::array<Eigen::Vector3d, 2>>& lines = {});

}  // namespace isopatch::geometry
