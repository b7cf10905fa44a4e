#pragma once

#include <Eigen/Core>

#include "geometry/brep/brep_parts.hpp"

namespace isopatch::segmentation {

/// How far a point is from a carrier, with signs: above a plane along its axis, outside of the others' axis
/// or centre.
struct CarrierDistance {
  double value = 0;          ///< m; to first order near a cone's apex
  Eigen::Vector3d gradient;  ///< unit: the carrier's normal at the nearest point
  /// Derivatives by the radius, by the second radius of a torus or the angle of a cone (m per rad).
  double by_radius = 0, by_second = 0;
};

CarrierDistance carrier_distance(const geometry::Carrier& carrier, const Eigen::Vector3d& point);

/// The same at many points, for each of which a cone needs no sine and cosine of its angle.
class CarrierDistances {
 public:
  explicit CarrierDistances(const geometry::Carrier& carrier);
  CarrierDistance at(const Eigen::Vector3d& point) const;

 private:
  geometry::Carrier carrier_;
  double cosine_, sine_;  ///< of a cone's half angle
};

/// Number of parameters of a carrier in space: 3 of a plane, 7 of a torus.
int freedoms(geometry::SurfaceKind kind);

/// A unit vector at right angles to an axis; the same for all parallel axes.
Eigen::Vector3d any_normal(const Eigen::Vector3d& axis);

}  // namespace isopatch::segmentation
