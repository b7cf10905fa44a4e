#pragma once

#include <functional>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// A spline of degree 5 over [0, 1] through points of a smooth curve.
geometry::NurbsCurve interpolated(const std::function<Eigen::Vector3d(double)>& curve);

/// The same of a curve that is smooth but for some places, as splines are at their knots: spans are halved
/// where it takes that.
/// @param tolerance  greatest distance from the curve, measured between the points: in its unit
/// @throws Error unsupported  not reached in spans of 1e-7: the curve has a corner
geometry::NurbsCurve interpolated(const std::function<Eigen::Vector3d(double)>& curve, double tolerance);

/// The same of a smooth surface over the unit square.
/// @param spans  along either direction, of equal lengths
geometry::NurbsSurface interpolated(const std::function<Eigen::Vector3d(double, double)>& surface,
                                    int spans = 8);

}  // namespace isopatch::segmentation
