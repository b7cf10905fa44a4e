#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/study/config_value.hpp"

namespace isopatch::app {

/// Patches that the study adds to faces of the model: [[model.attach]].
struct AttachmentInput {
  std::string name;                                   ///< of the boundary at the far ends, or ""
  std::vector<std::string> faces;                     ///< "1:north", or names of boundaries
  Eigen::Affine3d map = Eigen::Affine3d::Identity();  ///< from these faces to the far ends, model units
  Place place;
  bool operator==(const AttachmentInput& other) const {
    return name == other.name && faces == other.faces && map.matrix() == other.map.matrix() &&
           place == other.place;
  }
};

}  // namespace isopatch::app
