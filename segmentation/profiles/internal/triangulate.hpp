#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace isopatch::segmentation::planar {

/// Triangles of a polygon with holes: ears cut off, then edges flipped until they are Delaunay.
/// @param loops numbers of points: the outer one counterclockwise, first, then holes, clockwise
/// @return corners counterclockwise, every point a corner; nothing where loops cross or touch
/// @cost quadratic in the points
std::optional<std::vector<std::array<int, 3>>> triangulate(const std::vector<Eigen::Vector2d>& points,
                                                           const std::vector<std::vector<int>>& loops);

/// Whether two segments meet, their ends included.
bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d);

}  // namespace isopatch::segmentation::planar
