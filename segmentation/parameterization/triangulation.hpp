#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace isopatch::segmentation {

/// A triangulated polygon: its corners first, in their order, then points inside.
struct Triangulation {
  std::vector<Eigen::Vector2d> points;
  std::vector<std::array<int, 3>> triangles;  ///< counterclockwise
  int outline = 0;                            ///< number of the polygon's corners
};

/// Triangulates a simple polygon, corners in straight lines allowed, with inner points on a grid.
///
/// Ears are cut, inner points inserted, and edges flipped while that widens the smallest angle; the polygon's
/// edges are never touched.
/// @param outline       counterclockwise
/// @param inner_points  about how many
/// @throws Error internal if no ear is left, which means that the polygon crosses itself
/// @cost   O(points^2)
Triangulation triangulate(const std::vector<Eigen::Vector2d>& outline, int inner_points);

/// Divides every inner edge for which `divide(a, b)` holds, a and b its end points, at its middle.
void divide_edges(Triangulation& mesh, const std::function<bool(int, int)>& divide);

}  // namespace isopatch::segmentation
