#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace isopatch::app {

/// Triangles with a value at each corner, as they are drawn. Faces do not share points, so values may jump
/// there.
struct Surface {
  Eigen::Matrix3Xd points;      ///< as drawn, deformed
  Eigen::Matrix3Xd undeformed;  ///< the same material points before the deformation
  Eigen::Matrix3Xd normals;     ///< unit, outward; see `smooth_normals`
  Eigen::VectorXd values;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// Straight pieces, as they are drawn.
struct Lines {
  Eigen::Matrix3Xd points;
  Eigen::Matrix3Xd undeformed;
  std::vector<std::array<int, 2>> segments;
};

/// Twice the area of a triangle times its unit normal.
Eigen::Vector3d area_vector(const Surface& surface, const std::array<int, 3>& triangle);

/// Normals for soft shading: the mean over all triangles that meet in a place, of any face, but not across
/// edges sharper than 30 degrees.
/// @cost  O(points)
Eigen::Matrix3Xd smooth_normals(const Surface& surface);

/// Both, one after the other.
Surface joined(const Surface& first, const Surface& second);
Lines joined(const Lines& first, const Lines& second);

}  // namespace isopatch::app
