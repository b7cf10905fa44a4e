#include "iga/problem/region.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

Eigen::Vector3d unit(const Eigen::Vector3d& direction, const char* what) {
  if (!(direction.norm() > 0) || !direction.allFinite())
    throw Error(ErrorCode::invalid_argument, fmt::format("a region needs {} that is not 0", what));
  return direction.normalized();
}

void require_radius(double radius) {
  if (!(radius > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("a region needs a radius above 0, not {} m", radius));
}

// (R^2 - r . P r) / (2 R), whose slope where r is R is 1.
Region within(const Eigen::Vector3d& origin, const Eigen::Matrix3d& projector, double radius) {
  return {{{origin, radius / 2, Eigen::Vector3d::Zero(), -projector / (2 * radius)}}};
}

}  // namespace

double Quadric::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d r = place - origin;
  return value + slope.dot(r) + r.dot(curvature * r);
}

bool Region::contains(const Eigen::Vector3d& place, double slack) const {
  return std::all_of(bounds.begin(), bounds.end(),
                     [&](const Quadric& bound) { return bound.at(place) >= -slack; });
}

Region operator&(Region a, const Region& b) {
  a.bounds.insert(a.bounds.end(), b.bounds.begin(), b.bounds.end());
  return a;
}

Region half_space(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  return {{{point, 0, unit(normal, "a normal"), Eigen::Matrix3d::Zero()}}};
}

Region inside_cylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius) {
  require_radius(radius);
  const Eigen::Vector3d along = unit(axis, "an axis");
  return within(point, Eigen::Matrix3d::Identity() - along * along.transpose(), radius);
}

Region inside_sphere(const Eigen::Vector3d& centre, double radius) {
  require_radius(radius);
  return within(centre, Eigen::Matrix3d::Identity(), radius);
}

Region inside_box(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  if (!((max - min).array() > 0).all())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("a box from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m has no volume",
                            min[0], min[1], min[2], max[0], max[1], max[2]));
  Region result;
  for (int d = 0; d < 3; ++d) {
    result = std::move(result) & half_space(min, Eigen::Vector3d::Unit(d));
    result = std::move(result) & half_space(max, -Eigen::Vector3d::Unit(d));
  }
  return result;
}

}  // namespace isopatch::iga
