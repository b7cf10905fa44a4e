#pragma once

#include <vector>

#include "geometry/base/angle.hpp"
#include "geometry/brep/brep.hpp"

namespace isopatch::geometry {

/// What the inner dihedral angle of an edge is like.
enum class Convexity {
  convex,      ///< nowhere more than 180 degrees, and less somewhere
  non_convex,  ///< more than 180 degrees somewhere
  flat,        ///< 180 degrees everywhere: the faces have the same tangent planes
  seam,        ///< both sides are the same face, which continues across
  overused,    ///< between more than two faces
  free,        ///< of one face only
};
const char* name(Convexity convexity);

struct EdgeAngles {
  Convexity convexity = Convexity::free;
  Angle smallest, largest;  ///< inner dihedral angle, in (0, 360) degrees; 0 for free and overused edges
};

struct EdgeAngleOptions {
  /// Angles that differ less from 180 degrees count as flat. Range (0, 45 degrees).
  Angle flat = Angle::degrees(2.5);
  /// Places along each edge, the ends among them; at least 5.
  int samples = 17;
};

/// The dihedral angle of one edge, sampled.
///
/// With outward normals n1, n2 and the unit tangent d along the use of the first face, the angle is
/// 180 degrees - atan2((n1 x n2).d, n1.n2).
/// @source the isogeometric segmentation pipeline, section 2: convex is what has an inner angle below pi
/// everywhere
EdgeAngles edge_angles(const Brep& brep, EdgeId edge, const EdgeAngleOptions& options = {});

/// Of all edges.
std::vector<EdgeAngles> edge_angles(const Brep& brep, const EdgeAngleOptions& options = {});

}  // namespace isopatch::geometry
