#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/study/config_value.hpp"

namespace isopatch::app {

/// A sum of load cases, each with a factor: [[combination]].
struct CombinationInput {
  std::string name = {};
  std::vector<std::pair<std::string, double>> factors = {};  ///< by case; others count nothing
  Place place = {};
  bool operator==(const CombinationInput&) const = default;
};

}  // namespace isopatch::app
