#pragma once

#include <Eigen/Core>
#include <array>

namespace isopatch::segmentation {

/// Corner c of a cube has the coordinates 2 * bit - 1 of its bits, x first.
Eigen::Vector3d cube_corner(int corner);

/// The corners of each side of a cube, counter-clockwise as seen from outside.
inline constexpr std::array<std::array<int, 4>, 6> cube_sides = {
    {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};

/// A point of the unit sphere beside a side of the cube around it: equal steps of u and v are equal angles
/// about the cube's axes.
/// @param u  in [0, 1] from the side's first corner to its second
/// @param v  in [0, 1] from its first corner to its last
Eigen::Vector3d on_sphere(const std::array<int, 4>& side, double u, double v);

}  // namespace isopatch::segmentation
