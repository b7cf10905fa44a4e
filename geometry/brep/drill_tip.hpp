#pragma once

#include <Eigen/Core>

#include "geometry/base/ids.hpp"

namespace isopatch::geometry {

/// The point at the bottom of a drilled hole: a cone whose apex is on the solid's boundary.
struct DrillTip {
  FaceId cone;
  Eigen::Vector3d apex, axis;  ///< m; unit, out of the hole
  double radius = 0;           ///< where the cone begins, m
  double depth = 0;            ///< of the apex below that, m
};

}  // namespace isopatch::geometry
