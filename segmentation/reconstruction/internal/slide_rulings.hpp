#pragma once

#include <Eigen/Core>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Points of a surface that is straight between two curves in parallel planes.
struct RuledPoints {
  Eigen::Matrix3Xd points;  ///< (3, n), m
  Eigen::VectorXd v;        ///< share of the way from plane to plane; 0 and 1: on the curves
  Eigen::Vector3d up;       ///< unit, the planes' normal
};

struct RuledCurves {
  geometry::NurbsCurve low, high;  ///< over the same knots
  double largest = 0;              ///< distance of a point from the surface, m
  double largest_on_curves = 0;    ///< of a point of the curves from its curve, m
};

/// Moves the curves so that all points come to lie on the surface between them. Only distances across the
/// surface count, so that the ends of its lines slide along the curves until they pass through the points
/// inside; what points do not say stays as it was. Ends of curves stay; knots are halved where points of the
/// curves are off by more than the tolerance.
/// @param start  over the same knots
/// @cost  some ten dense systems of the control points
RuledCurves slide_rulings(const RuledCurves& start, RuledPoints points, double tolerance);

}  // namespace isopatch::segmentation
