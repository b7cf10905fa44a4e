#pragma once

#include "geometry/base/angle.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// Exact circular arc parallel to the x-y plane: one rational quadratic piece over [0, 1] with weights
/// 1, cos(half the angle), 1.
///
/// @param center  model units; its z is the arc's
/// @param radius  positive, model units
/// @param from    angle of the first point, counted from x towards y
/// @param to      angle of the last point; below `from` for a clockwise arc; |to - from| < 180 degrees
/// @return        points that lie on the circle to round-off
/// @throws Error  invalid_argument for a radius or an angle outside its range
/// @source        Piegl, Tiller, The NURBS Book, section 7.3
NurbsCurve arc(const Eigen::Vector3d& center, double radius, Angle from, Angle to);

/// Exact circular arc in space: `start` turned about an axis through `center` by `sweep`.
///
/// @param axis   direction, not zero, any length; need not be normal to start - center
/// @param sweep  |sweep| in (0, 180) degrees, right-handed about the axis
/// @throws Error invalid_argument for an angle outside its range, an axis of no length or a start on the axis
NurbsCurve arc_about(const Eigen::Vector3d& center, const Eigen::Vector3d& axis, const Eigen::Vector3d& start,
                     Angle sweep);

/// The segment from one point to another: degree 1 over [0, 1].
NurbsCurve segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// The fewest equal pieces of at most `largest_piece` that make up `sweep`.
/// @throws Error invalid_argument unless both are positive
int arc_piece_count(Angle sweep, Angle largest_piece = Angle::degrees(90));

}  // namespace isopatch::geometry
