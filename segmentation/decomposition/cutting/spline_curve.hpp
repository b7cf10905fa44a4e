#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// A curve in space by its points, m; over [0, 1].
using CurvePoints = std::function<Eigen::Vector3d(double)>;

/// The spline that a curve is interpolated by, in the space of given knots over [0, 1]; its ends are the
/// curve's.
/// @cost  a dense system with as many unknowns as control points
geometry::NurbsCurve interpolated(const CurvePoints& curve, const geometry::KnotVector& knots);

/// Largest distance found between a curve and a spline at equal parameters, m.
double deviation(const CurvePoints& curve, const geometry::NurbsCurve& spline);

/// The knots over [0, 1] with which interpolation follows curves up to `tolerance`: one piece of degree 1
/// where all are straight at constant speed, otherwise degree 5 with as many equal spans as it takes, 64 at
/// most.
/// @param tolerance  m
geometry::KnotVector following_knots(const std::vector<CurvePoints>& curves, double tolerance);

}  // namespace isopatch::segmentation
