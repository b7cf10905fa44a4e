#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::geometry {

/// Plane faces of a solid pushed along their normal into one plane and laid over each other: the drawing that one
/// sees who looks at them from afar.
///
/// The result is no solid but a sheet of plane faces, each a region that is covered by the same faces
/// everywhere, without names. They look along `direction`, share edges and vertices, and what no face covers is none.
/// Outlines that agree to 1e-7 of the solid's size become one.
/// @param faces      plane, at right angles to `direction`; at least one
/// @param origin     of the plane, m
/// @param direction  unit
/// @throws Error unsupported  the CAD library cannot lay them over each other
/// @cost  that of a general fuse: some milliseconds a face
Brep overlay(const Brep& solid, const std::vector<FaceId>& faces, const Eigen::Vector3d& origin,
             const Eigen::Vector3d& direction);

}  // namespace isopatch::geometry
