#pragma once

#include <functional>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// A spline of degree 5 over [0, 1] through points of a smooth curve.
geometry::NurbsCurve interpolated(const std::function<Eigen::Vector3d(double)>& curve);

/// The same of a smooth surface over the unit square.
geometry::NurbsSurface interpolated(const std::function<Eigen::Vector3d(double, double)>& surface);

}  // namespace isopatch::segmentation
