#pragma once

#include <Eigen/Core>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Length of a polygon; 0 for one point.
/// @param points  (3, n)
double length_of(const Eigen::Matrix3Xd& points);

/// How much longer a line along a polygon is than arcs that turn as the polygon does: 1 for a smooth curve
/// through its vertices, more for one with waves between them, which no distance of vertices shows.
/// @param line  (3, m), m >= 2, many points for each of the polygon's
/// @param polygon  (3, n), n >= 2, neighbours apart
double waviness(const Eigen::Matrix3Xd& line, const Eigen::Matrix3Xd& polygon);

/// What `waviness` smooth curves stay below.
constexpr double most_waviness = 1.01;

/// Distance of a curve from a polygon along it, between the vertices too, m.
/// @param polygon  (3, n), n >= 2, neighbours apart
/// @cost  O(n^2)
double farthest(const geometry::NurbsCurve& curve, const Eigen::Matrix3Xd& polygon);

/// Whether a curve along a polygon has no waves between its vertices and does not run back on itself.
/// @param polygon  (3, n), n >= 2, neighbours apart
/// @cost  O(n^2)
bool is_steady(const geometry::NurbsCurve& curve, const Eigen::Matrix3Xd& polygon);

}  // namespace isopatch::segmentation
