#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/config_value.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// Patches that the study adds to faces of the model: [[model.attach]].
struct AttachmentInput {
  std::string name;                                   ///< of the boundary at the far ends, or ""
  std::vector<std::string> faces;                     ///< "1:north", or names of boundaries
  Eigen::Affine3d map = Eigen::Affine3d::Identity();  ///< from these faces to the far ends, model units
  Place place;
};

/// The patches with all attachments, one after the other: later ones may name faces of earlier ones.
/// @throws Error invalid_argument, beginning with the attachment's place, for faces that do not exist and
/// maps
///     that leave a patch without thickness
geometry::PatchSet attached(geometry::PatchSet set, const std::vector<AttachmentInput>& attachments);

}  // namespace isopatch::app
