#pragma once

#include <Eigen/Core>
#include <vector>

namespace isopatch::segmentation {

/// How a whole turn is to be divided, for those that go on with its hexahedra.
struct TurnedRequest {
  /// A line in a half-plane of the axis up to the next curve there: becomes sides of quadrilaterals.
  struct Ray {
    Eigen::Vector3d from;   ///< m; where a curve or a ray before it is
    Eigen::Vector3d along;  ///< in the half-plane of `from`
  };
  std::vector<Ray> rays = {};  ///< each in a half-plane of its own, all taken as in one
  Eigen::Vector3d towards;     ///< from the axis to the middle of a sector
  int sectors = 4;             ///< 4 where material reaches the axis, else 3 or more
  double core_share = 0.6;     ///< of the smallest radius beside the axis: the column's corners, in (0, 0.9)
};

}  // namespace isopatch::segmentation
