#pragma once

#include <Eigen/Core>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// The ellipsoid that has a solid's volume, centre of gravity and axes of inertia.
struct BallFrame {
  Eigen::Vector3d centre;  ///< m
  Eigen::Matrix3d axes;    ///< orthonormal columns, right-handed
  Eigen::Vector3d radii;   ///< m, along the axes

  /// A point of the unit sphere on the ellipsoid, m.
  Eigen::Vector3d point(const Eigen::Vector3d& on_sphere) const {
    return centre + axes * radii.cwiseProduct(on_sphere);
  }
};

/// @cost  a triangulation, within 1e-3 of the solid's size
BallFrame ball_frame(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
