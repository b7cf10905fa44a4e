#pragma once

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// A curve turned about an axis: exact, quadratic over [0, 1] along the circles, which are the first
/// direction.
/// @param axis   unit
/// @param sweep  rad, in (0, pi)
geometry::NurbsSurface turned_surface(const geometry::NurbsCurve& curve, const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& axis, double sweep);

/// A sphere seen from one of its points, projected on the plane across from there: biquadratic and exact all
/// around `middle`, which has the parameters (0, 0); circles are circles in its domain.
class SpherePatch {
 public:
  /// @param middle   unit
  /// @param inwards  where it is to look
  SpherePatch(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& middle, bool inwards);

  /// @param reach  largest parameter
  geometry::NurbsSurface surface(double reach) const;
  /// A curve on the sphere in the domain, at the same pace.
  geometry::NurbsCurve trace(const geometry::NurbsCurve& curve) const;

 private:
  Eigen::Vector3d centre_, x_, y_, z_;
  double radius_;
};

}  // namespace isopatch::segmentation
