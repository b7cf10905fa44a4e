#pragma once

#include <Eigen/Geometry>

#include "geometry/multi_patch.hpp"

namespace isopatch::verification {

/// x becomes linear x + shift.
struct Motion {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< model units
};

inline geometry::PatchSet moved(geometry::PatchSet set, const Motion& motion) {
  for (geometry::NurbsVolume& patch : set.patches) {
    const Eigen::Matrix3Xd points = (motion.linear * patch.control_points()).colwise() + motion.shift;
    patch = geometry::NurbsVolume(patch.knots(), points, patch.weights());
  }
  return set;
}

/// The patches of both; the second ones' boundaries are named "x_min, second" and so on.
inline geometry::PatchSet together(const geometry::PatchSet& first, const geometry::PatchSet& second) {
  geometry::PatchSet result = first;
  const auto offset = static_cast<int>(first.patches.size());
  result.patches.insert(result.patches.end(), second.patches.begin(), second.patches.end());
  for (geometry::Boundary boundary : second.boundaries) {
    for (geometry::PatchFace& face : boundary.faces) face.patch = PatchId(face.patch.value + offset);
    boundary.name += ", second";
    result.boundaries.push_back(boundary);
  }
  for (geometry::StatedInterface stated : second.interfaces) {
    for (geometry::PatchFace* face : {&stated.first, &stated.second})
      face->patch = PatchId(face->patch.value + offset);
    result.interfaces.push_back(stated);
  }
  return result;
}

/// A rotation that leaves no axis near a coordinate plane.
inline Eigen::Matrix3d oblique_rotation() {
  return Eigen::AngleAxisd(0.83, Eigen::Vector3d(0.4, -0.7, 0.6).normalized()).toRotationMatrix();
}

}  // namespace isopatch::verification
