#include "segmentation/balls/internal/cube_sides.hpp"

#include <cmath>
#include <numbers>

namespace isopatch::segmentation {

Eigen::Vector3d cube_corner(int corner) {
  return {corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
}

Eigen::Vector3d on_sphere(const std::array<int, 4>& side, double u, double v) {
  const Eigen::Vector3d first = cube_corner(side[0]);
  const Eigen::Vector3d flat =
      first + u * (cube_corner(side[1]) - first) + v * (cube_corner(side[3]) - first);
  const auto by_angle = [](double x) { return std::tan(std::numbers::pi / 4 * x); };
  return flat.unaryExpr(by_angle).normalized();
}

}  // namespace isopatch::segmentation
