#pragma once

#include <Eigen/Core>

#include "geometry/interface.hpp"
#include "segmentation/parameterization/internal/face_map.hpp"

namespace isopatch::segmentation {

/// How far two faces are from being one, in the orientation in which they are closest.
struct FaceContact {
  geometry::FaceOrientation orientation;  ///< from the first face to the second
  double distance = 0;                    ///< largest found, of corners, sides and some inner points; m
  Eigen::Vector3d place;                  ///< where
};
/// Sides are compared by arc length, inner points of the first with the nearest of the second.
FaceContact contact(const FaceMap& first, const FaceMap& second);

/// A face's point near another point.
struct FaceFoot {
  geometry::Parameter<2> at;  ///< in the face's frame, sides included
  double distance = 0;        ///< m
};
/// The nearest point of a face.
/// @param reach  farther points need not be the nearest
FaceFoot foot(const FaceMap& face, const Eigen::Vector3d& point, double reach);

}  // namespace isopatch::segmentation
