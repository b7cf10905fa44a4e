#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/study/attachment_input.hpp"
#include "app/study/config_section.hpp"
#include "app/study/model_units.hpp"

namespace isopatch::app {

/// What [[model.attach]] says.
struct AttachmentKeys {
  std::string name;
  std::vector<std::string> faces;
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Vector3d about = Eigen::Vector3d::Zero();
};
Keys<AttachmentKeys> attachment_keys(ModelUnits units);

/// @throws Error invalid_argument  for wrong keys, and one that neither moves nor scales
AttachmentInput read_attachment(const ConfigSection& input, ModelUnits units);

}  // namespace isopatch::app
