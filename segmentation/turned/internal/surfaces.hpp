#pragma once

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// A curve turned about an axis: exact, quadratic over [0, 1] along the circles, which are the first
/// direction.
/// @param axis   unit
/// @param sweep  rad, in (0, pi)
geometry::NurbsSurface turned_surface(const geometry::NurbsCurve& curve, const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& axis, double sweep);

/// A sphere, or what becomes of it where it is stretched along a line through its centre.
struct Spheroid {
  Eigen::Vector3d centre;
  double radius;          ///< across that line
  Eigen::Vector3d along;  ///< unit
  double stretch = 1;     ///< of the radius along the line

  Eigen::Vector3d stretched(const Eigen::Vector3d& point) const;    ///< of the sphere
  Eigen::Vector3d unstretched(const Eigen::Vector3d& point) const;  ///< on the sphere
  /// What a great circle between two points becomes.
  geometry::NurbsCurve arc(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
};

/// A spheroid, as a sphere seen from one of its points, projected on the plane across from there: biquadratic
/// and exact all around `middle`, which has the parameters (0, 0); circles are circles in its domain.
class SpherePatch {
 public:
  /// @param middle   direction on the sphere, unit
  /// @param inwards  where it is to look
  SpherePatch(const Spheroid& spheroid, const Eigen::Vector3d& middle, bool inwards);

  /// @param reach  largest parameter
  geometry::NurbsSurface surface(double reach) const;
  /// A curve on the spheroid in the domain, at the same pace.
  geometry::NurbsCurve trace(const geometry::NurbsCurve& curve) const;

 private:
  Spheroid spheroid_;
  Eigen::Vector3d x_, y_, z_;
};

}  // namespace isopatch::segmentation
