#pragma once

#include <Eigen/Core>
#include <vector>

namespace isopatch::iga {

/// A surface of second degree and which side of it counts: the places x where
/// value + slope . r + r . curvature r >= 0 with r = x - origin. Scaled so that near the surface that is
/// about the distance from it, m.
struct Quadric {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     ///< m
  double value = 0;                                     ///< m
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();      ///< dimensionless
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  ///< symmetric, 1/m

  double at(const Eigen::Vector3d& place) const;
  bool operator==(const Quadric&) const = default;
};

/// The part of space that is on the right side of some quadrics; all of it without any.
struct Region {
  std::vector<Quadric> bounds = {};

  bool is_everywhere() const { return bounds.empty(); }
  /// @param slack  how far outside a place may be, m
  bool contains(const Eigen::Vector3d& place, double slack = 0) const;
  bool operator==(const Region&) const = default;
};

/// What lies in both.
Region operator&(Region a, const Region& b);

/// The side of a plane to which its normal points.
/// @param normal  of any length
/// @throws Error invalid_argument  a normal of 0
Region half_space(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);
/// What lies within a radius of an axis.
/// @throws Error invalid_argument  an axis of 0, a radius that is not positive
Region inside_cylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius);
/// @throws Error invalid_argument  a radius that is not positive
Region inside_sphere(const Eigen::Vector3d& centre, double radius);
/// A box with edges along the axes.
/// @throws Error invalid_argument  no extent along an axis
Region inside_box(const Eigen::Vector3d& min, const Eigen::Vector3d& max);

}  // namespace isopatch::iga
