#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/config_section.hpp"
#include "app/study/keys.hpp"
#include "app/study/model_input.hpp"

namespace isopatch::app {

/// What [model] says before its generator's keys.
struct ModelKeys {
  std::optional<std::string> file;
  std::vector<std::string> blocks;
  std::optional<std::string> pairs;
  std::optional<std::string> generate;
  std::optional<ConfigValue> attach;
  double length_unit = 1;
  bool gives_length_unit = false;
  bool allow_partial = false;
  double cad_time_limit = 0;
  double cad_memory_limit = 0;
  double same_point = Tolerance{}.same_point;
  double near_miss = Tolerance{}.near_miss;
  double same_knot = Tolerance{}.same_knot;
};

const Keys<ModelKeys>& model_keys();

/// The sections that say how solids become patches.
struct SolidSections {
  ConfigSection parameterization, segmentation, reconstruction;
};

/// @param input   [model]
/// @param how     for models made of solids
/// @param source  path of the study, for relative paths
/// @throws Error invalid_argument  for wrong keys, and for none or several sources of patches
ModelInput read_model(const ConfigSection& input, const SolidSections& how, const std::string& source);

}  // namespace isopatch::app
