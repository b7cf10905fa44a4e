#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/study/config_value.hpp"
#include "geometry/base/angle.hpp"

namespace isopatch::app {

/// Geometric conditions on faces; lengths in m, directions of length 1.
struct PlaneCondition {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  bool operator==(const PlaneCondition&) const = default;
};
struct CylinderCondition {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the axis
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double radius = 0;
  bool operator==(const CylinderCondition&) const = default;
};
struct SphereCondition {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
  bool operator==(const SphereCondition&) const = default;
};
struct BoxCondition {
  Eigen::Vector3d min = Eigen::Vector3d::Zero();
  Eigen::Vector3d max = Eigen::Vector3d::Zero();
  bool operator==(const BoxCondition&) const = default;
};

/// All conditions given must hold at all sample points of a face.
struct FaceConditions {
  std::optional<PlaneCondition> plane = {};
  std::optional<CylinderCondition> cylinder = {};
  std::optional<SphereCondition> sphere = {};
  std::optional<BoxCondition> box = {};
  std::optional<Eigen::Vector3d> normal = {};  ///< the outward normal, within `angle`
  Angle angle = Angle::degrees(5);
  std::optional<double> tolerance = {};  ///< m; none: 1e-4 of the model's size
  bool operator==(const FaceConditions&) const = default;
};

/// Boundary faces by names, by geometry, or by both (the faces named that also fulfil the conditions).
struct FaceSelection {
  std::vector<std::string> faces = {};  ///< as the study names them; see problem/face_name
  std::optional<FaceConditions> where = {};
  /// Of these faces, or of all, only what lies in here: on the side of the plane to which its normal points,
  /// within the cylinder, the sphere, the box; normal, angle and tolerance say nothing.
  std::optional<FaceConditions> part = {};
  Place place = {};  ///< in the study file
  bool operator==(const FaceSelection&) const = default;
};

/// Patches by index or name; neither means all.
struct PatchSelection {
  std::vector<std::pair<int, int>> ranges = {};  ///< first and last, both included
  std::vector<std::string> names = {};           ///< of bodies that became patches
  Place place = {};
  bool operator==(const PatchSelection&) const = default;
};

}  // namespace isopatch::app
