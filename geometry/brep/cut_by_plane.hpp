#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::geometry {

/// A part of a solid that a plane has cut off.
struct CutPart {
  Brep brep;
  /// By face of the part: the face of the solid that it is a piece of; nothing for those in the plane that
  /// the cut has made.
  std::vector<std::optional<FaceId>> origin;
};

/// Cuts a solid by a plane into parts, which lie on one side of it each. Faces keep names and colours.
/// @param point   on the plane, m
/// @param normal  unit
/// @return  the solid alone where the plane does not cut it
/// @throws Error unsupported  the CAD library cannot do it, or what comes of it has another volume
/// @cost  that of a general fuse: some milliseconds a face
std::vector<CutPart> cut_by_plane(const Brep& solid, const Eigen::Vector3d& point,
                                  const Eigen::Vector3d& normal);

}  // namespace isopatch::geometry
