#pragma once

#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// The common axis of cylindrical faces.
struct FaceAxis {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       ///< on it, nearest to the faces' centroid, m
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of length 1, the largest component positive
  double off = 0;   ///< how far the farthest normal passes by the axis, m
  double tilt = 0;  ///< largest cosine between a normal and the axis: 0 for cylinders
};

/// The axis that the normals of some faces meet at right angles, by least squares; `off` and `tilt` say how
/// well. Of plane faces there is none: `off` is large or `tilt` is, or both are not finite.
FaceAxis face_axis(const geometry::MultiPatch& model, const std::vector<geometry::PatchFace>& faces);

}  // namespace isopatch::iga
