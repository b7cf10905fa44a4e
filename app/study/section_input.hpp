#pragma once

#include <string>

#include "app/study/config_value.hpp"
#include "iga/post/plane_section.hpp"

namespace isopatch::app {

/// A cut through the part whose forces are wanted: [[section]].
struct SectionInput {
  std::string name = {};
  iga::CuttingPlane plane = {};
  Place place = {};
  bool operator==(const SectionInput&) const = default;
};

}  // namespace isopatch::app
