#pragma once

#include "geometry/interface.hpp"

namespace isopatch::geometry {

/// How well one face lies on another.
struct FaceMatch {
  FaceOrientation orientation;  ///< from the first face to the second, the best of the eight
  double distance = 0;          ///< largest distance found between points of equal parameters, model units
  Parameter<2> parameter;       ///< where on the first face it was found, scaled to [0, 1]^2
  Eigen::Vector3d first_point;  ///< the first face there
  Eigen::Vector3d second_point;
};

/// Compares two faces with parameters scaled to [0, 1]^2, in the orientation that fits best.
///
/// The points compared are a grid of degree + 1 points per direction on every span between the breaks of
/// either, so that two B-spline faces that agree there are equal.
///
/// @cost O(control points of both) for each orientation that cannot be excluded by its corners
FaceMatch match_faces(const NurbsSurface& first, const NurbsSurface& second);

/// The same in a given orientation, from first to second.
FaceMatch match_faces(const NurbsSurface& first, const NurbsSurface& second,
                      const FaceOrientation& orientation);

/// A surface parameter from one scaled to [0, 1]^2.
Parameter<2> unscaled(const NurbsSurface& surface, const Parameter<2>& scaled);

}  // namespace isopatch::geometry
