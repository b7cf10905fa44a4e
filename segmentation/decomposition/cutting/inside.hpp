#pragma once

#include <Eigen/Core>

#include "segmentation/decomposition/cutting/cell_shapes.hpp"

namespace isopatch::segmentation {

inline constexpr double triangles_off = 5e-3;

/// Triangles around a cell, outwards, (3, 3 n), m: fans of its plane sides with straight edges, whose
/// triangles may overlap and face inwards where a side is not convex; what overlaps cancels. Else the
/// triangulation of the CAD library, which may lie `triangles_off` of the cell's size off its sides.
/// @cost  O(edges); with curved sides 10 ms and more
Eigen::Matrix3Xd boundary_triangles(const CellShapes& shapes, geometry::CellId cell);

/// How often closed triangles, (3, 3 n), wind around a point: 1 inside, 0 outside, anything on them.
/// @cost  O(triangles)
/// @source van Oosterom, Strackee, The solid angle of a plane triangle, 1983
double winding_number(const Eigen::Matrix3Xd& triangles, const Eigen::Vector3d& point);

/// Whether a point of the plane lies in a polygon, (2, n); either sense.
bool is_inside(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& point);

/// Distance of a point from the outline of a polygon, (2, n).
double distance_to(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& point);

/// Points spread over the inside of a polygon, none on its outline, 20 or more where it is not very thin; (2,
/// n).
/// @param clear  distance that they keep from the outline at least, if the polygon is wide enough
Eigen::Matrix2Xd points_inside(const Eigen::Matrix2Xd& polygon, double clear = 0);

}  // namespace isopatch::segmentation
