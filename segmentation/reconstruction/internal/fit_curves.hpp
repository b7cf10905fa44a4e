#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Points along a curve at their parameters.
struct CurveSample {
  Eigen::VectorXd t;        ///< increasing from 0 to 1
  Eigen::Matrix3Xd points;  ///< (3, t.size()), m; at least two
};

struct FittedCurves {
  std::vector<geometry::NurbsCurve> curves;  ///< cubic, twice differentiable, over the same knots
  double largest = 0;                        ///< distance of a point from its curve at its parameter, m
};

/// Cubic splines over common knots near points, through the first and the last of each: knots are halved
/// where a point is off by more than the tolerance, as long as points are there to say how. What they leave
/// open is made smooth. Points of a plane give a curve in it.
/// @cost  O(points) a round, some ten rounds
FittedCurves fit_curves(const std::vector<CurveSample>& samples, double tolerance);

/// A sample with parameters in proportion to the length of the polygon through the points.
/// @param points  (3, n), n >= 2, neighbours apart
CurveSample by_length(const Eigen::Matrix3Xd& points);

}  // namespace isopatch::segmentation
