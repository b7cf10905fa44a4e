#pragma once

#include <Eigen/Geometry>

namespace isopatch::segmentation {

/// How a solid is seen along a direction.
struct PlanView {
  Eigen::Vector3d origin, x, y,
      along;  ///< m; unit, right-handed: `along` is x cross y and looks at the viewer

  Eigen::Vector2d flat(const Eigen::Vector3d& point) const {
    return {(point - origin).dot(x), (point - origin).dot(y)};
  }
  double height(const Eigen::Vector3d& point) const { return (point - origin).dot(along); }
  Eigen::Vector3d point(const Eigen::Vector2d& flat, double height) const {
    return origin + flat[0] * x + flat[1] * y + height * along;
  }
};

}  // namespace isopatch::segmentation
