#pragma once

#include <optional>

#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/face_map.hpp"

namespace isopatch::segmentation {

/// How far two faces are from being one, in the orientation in which they are closest.
struct FaceContact {
  geometry::FaceOrientation orientation;  ///< from the first face to the second
  double distance = 0;    ///< largest found, of corners, sides and some inner points; model units
  Eigen::Vector3d place;  ///< where
};
/// Sides are compared by arc length, inner points of the first with the nearest of the second.
FaceContact contact(const FaceMap& first, const FaceMap& second);

/// Distance of a point to a face, corners and sides included; model units.
/// @param reach  distances above it need not be exact
double distance(const FaceMap& face, const Eigen::Vector3d& point, double reach);

}  // namespace isopatch::segmentation
