#pragma once

#include <Eigen/Core>
#include <vector>

namespace isopatch::geometry {

/// A polygon that is plane or nearly so as triangles with the same vertices, by cutting off its ears, the
/// best shaped first.
/// @param vertices  that the polygon's numbers refer to
/// @param polygon   at least three different ones, in turn
/// @return (3, polygon.size() - 2); their sense is the polygon's
/// @throws Error bad_format  it crosses itself
/// @cost  O(n^3) for n corners, O(1) for three and four
Eigen::Matrix3Xi polygon_triangles(const Eigen::Matrix3Xd& vertices, const std::vector<int>& polygon);

}  // namespace isopatch::geometry
