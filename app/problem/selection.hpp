#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/study/face_selection.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// How far a point is from fulfilling all conditions but that on the normal, m.
double distance(const FaceConditions& conditions, const Eigen::Vector3d& point);

/// A face that `where` leaves out although it comes close.
struct NearMiss {
  geometry::PatchFace face;
  double distance =
      0;  ///< from the place asked for, of the sample point farthest from it, m; above the tolerance
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
