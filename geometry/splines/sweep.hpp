#pragma once

#include "geometry/base/angle.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// The straight blend from one spline (parameter 0 of the new, last direction) to another (1), exact at both
/// ends.
///
/// The two are brought to common degrees and knots first; both must run over the same parameters. Weights are
/// blended as given, so if the two have proportional weights the new direction's lines are traversed at
/// constant speed for equal weights; else they are straight but their parameter is rational.
///
/// @throws Error invalid_argument if the parameter ranges differ
NurbsSurface ruled(const NurbsCurve& from, const NurbsCurve& to);
NurbsVolume ruled(const NurbsSurface& from, const NurbsSurface& to);

/// A spline moved along a vector: degree 1 over [0, 1] in the new, last direction.
/// @throws Error invalid_argument for a vector of no length
NurbsSurface extruded(const NurbsCurve& curve, const Eigen::Vector3d& vector);
NurbsVolume extruded(const NurbsSurface& surface, const Eigen::Vector3d& vector);

/// A surface turned about an axis: exact, rational quadratic over [0, 1] in the new, last direction, weights
/// times 1, cos(half the angle), 1.
///
/// @param axis   direction, not zero, any length
/// @param sweep  |sweep| in (0, 180) degrees, right-handed about the axis
/// @throws Error invalid_argument for an angle outside its range or an axis of no length
/// @source       Piegl, Tiller, The NURBS Book, section 8.5
NurbsVolume revolved(const NurbsSurface& surface, const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                     Angle sweep);

}  // namespace isopatch::geometry
