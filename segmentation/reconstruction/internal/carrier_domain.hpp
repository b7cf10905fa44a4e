#pragma once

#include <Eigen/Core>

#include "geometry/brep/brep_parts.hpp"

namespace isopatch::segmentation {

/// Parameters on a carrier: the turn around its axis from a direction, rad; height, latitude or the turn
/// around a torus' tube.
class CarrierDomain {
 public:
  /// @param carrier  no plane
  explicit CarrierDomain(const geometry::Carrier& carrier);
  Eigen::Vector2d parameters(const Eigen::Vector3d& point) const;
  Eigen::Vector3d point(const Eigen::Vector2d& parameters) const;
  /// The plane through the axis at a turn.
  geometry::Carrier meridian(double turn) const;
  /// The surface through all points of a torus with this turn around the tube: a cone about the axis, or a
  /// plane or cylinder.
  geometry::Carrier parallel(double turn) const;

 private:
  geometry::Carrier carrier_;
  Eigen::Vector3d x_, y_;
};

}  // namespace isopatch::segmentation
