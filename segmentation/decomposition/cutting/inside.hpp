#pragma once

#include <Eigen/Core>

#include "geometry/brep/tessellation.hpp"

namespace isopatch::segmentation {

/// How often a closed triangulation winds around a point: 1 inside, 0 outside, anything on it.
/// @cost  O(triangles)
/// @source van Oosterom, Strackee, The solid angle of a plane triangle, 1983
double winding_number(const geometry::Tessellation& boundary, const Eigen::Vector3d& point);

/// Whether a point of the plane lies in a polygon, (2, n); either sense.
bool is_inside(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& point);

/// Points spread over the inside of a polygon, 20 or more where it is not very thin; (2, n).
Eigen::Matrix2Xd points_inside(const Eigen::Matrix2Xd& polygon);

}  // namespace isopatch::segmentation
