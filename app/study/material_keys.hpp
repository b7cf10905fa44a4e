#pragma once

#include <optional>
#include <string>

#include "app/study/config_section.hpp"
#include "app/study/keys.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

struct LameKeys {
  double lambda = 0;
  double mu = 0;
};

/// What [[material]] says, before it is known which constants it gives.
struct MaterialKeys {
  std::optional<PatchSelection> patches;
  std::optional<std::string> name;
  std::optional<LameKeys> lame;
  std::optional<double> young;
  std::optional<double> poisson;
  std::optional<double> density;
  std::optional<double> expansion;
  std::optional<double> yield;
};

const Keys<MaterialKeys>& material_keys();
const Keys<LameKeys>& lame_keys();

/// @throws Error invalid_argument  for wrong keys, constants that are missing or too many, unknown names
MaterialInput read_material(const ConfigSection& input);

}  // namespace isopatch::app
