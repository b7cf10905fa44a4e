#pragma once

#include "app/base/choices.hpp"
#include "app/study/keys.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::app {

/// What [parameterization] says.
struct ParameterizationKeys {
  segmentation::ParameterizationOptions options;
  bool gives_tolerance = false;
  double same_point = segmentation::AssemblyOptions{}.same_point;
};

const Keys<ParameterizationKeys>& parameterization_keys();

/// "shared", "paper".
const Choices<segmentation::ParameterizationMethod>& parameterization_methods();

}  // namespace isopatch::app
