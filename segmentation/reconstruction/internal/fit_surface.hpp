#pragma once

#include <Eigen/Core>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Points of a surface and where they lie in its domain.
struct PlacedPoints {
  Eigen::Matrix3Xd points;  ///< m
  Eigen::Matrix2Xd places;  ///< (2, points), in lengths about those of the surface
  Eigen::VectorXd weights;  ///< (points)
};

struct FittedSurface {
  geometry::NurbsSurface
      surface;              ///< bicubic, twice differentiable; its domain is a little larger than the places
  Eigen::Matrix2Xd places;  ///< of the points nearest to those given
  Eigen::VectorXd off;      ///< (points), m, the distances
};

/// A spline surface near points: least squares with a little of the bending energy, which decides what the
/// points leave open. Knots are halved where points are off by more than the tolerance, across the direction
/// in which the surface bends more there; each time the points' places move to where they are nearest.
/// @param points  with places that determine a plane at least
/// @param tolerance  m; not always reached, see `off`
/// @param most  control points, and three times as many as there are points
/// @cost  some fifteen sparse systems of the control points
/// @source Weiss, Andor, Renner, Varady, Advanced surface fitting techniques, 2002; Hoschek, Intrinsic
/// parametrization for approximation, 1988
FittedSurface fit_surface(const PlacedPoints& points, double tolerance, int most = 2500);

}  // namespace isopatch::segmentation
