#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/config_value.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// Geometric conditions on faces; lengths in m, directions of length 1.
struct PlaneCondition {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};
struct CylinderCondition {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the axis
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double radius = 0;
};
struct SphereCondition {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
};
struct BoxCondition {
  Eigen::Vector3d min = Eigen::Vector3d::Zero();
  Eigen::Vector3d max = Eigen::Vector3d::Zero();
};

/// All conditions given must hold at all sample points of a face.
struct FaceConditions {
  std::optional<PlaneCondition> plane = {};
  std::optional<CylinderCondition> cylinder = {};
  std::optional<SphereCondition> sphere = {};
  std::optional<BoxCondition> box = {};
  std::optional<Eigen::Vector3d> normal = {};  ///< the outward normal, within `angle`
  double angle = 0.08726646259971647;          ///< rad; 5 degrees
  std::optional<double> tolerance = {};        ///< m; none: 1e-4 of the model's size
};

/// How far a point is from fulfilling all conditions but that on the normal, m.
double distance(const FaceConditions& conditions, const Eigen::Vector3d& point);

/// Boundary faces by names, by geometry, or by both (the faces named that also fulfil the conditions).
struct FaceSelection {
  std::vector<std::string> faces = {};  ///< "0:back" in the input's naming, or the name of a boundary
  std::optional<FaceConditions> where = {};
  Place place = {};  ///< in the study file
};

/// Patches by index or name; neither means all.
struct PatchSelection {
  std::vector<std::pair<int, int>> ranges = {};  ///< first and last, both included
  std::vector<std::string> names = {};           ///< of bodies that became patches
  Place place = {};
};

/// A face that `where` leaves out although it comes close.
struct NearMiss {
  geometry::PatchFace face;
  double distance = 0;  ///< of its farthest sample point from what was asked for, m; above the tolerance
};

/// What a selection catches.
struct SelectedFaces {
  std::vector<geometry::PatchFace> faces;  ///< increasing, each once
  /// Faces that miss the tolerance by less than a factor of 5 and point the right way, the nearest first.
  std::vector<NearMiss> near_misses = {};
  double tolerance = 0;  ///< m; 0 without geometric conditions
};

/// The boundary faces that a selection names.
///
/// Geometric conditions are tested on a 9 x 9 grid of points of each boundary face.
///
/// @param model  in m
/// @throws Error invalid_argument  a face that does not exist or is no boundary; a selection that matches
///     nothing, listing the boundaries' names and the faces that came nearest. Each begins with the place.
SelectedFaces select_faces(const geometry::MultiPatch& model, const FaceSelection& selection);

/// Says which faces a selection leaves out by little, and the tolerance that would include them; empty if
/// there are none.
std::string near_miss_warning(const geometry::MultiPatch& model, const FaceSelection& selection,
                              const std::string& name, const SelectedFaces& selected);

/// @return increasing, each once
/// @throws Error invalid_argument for patches that do not exist, naming what comes near
std::vector<PatchId> select_patches(const geometry::MultiPatch& model, const PatchSelection& selection);

}  // namespace isopatch::app
