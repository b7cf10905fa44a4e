#pragma once

#include <optional>
#include <string>

#include "app/study/config_value.hpp"

namespace isopatch::app {

/// How accurate a run shall be: [accuracy]. Without either goal it is as accurate as its discretization.
struct AccuracyInput {
  std::optional<double> energy = {};  ///< largest error in the energy norm, relative
  std::optional<double> stress = {};  ///< largest error of a von Mises stress, relative
  std::string probe = {};             ///< whose stress that is; "": the largest of the part
  int refinements = 10;               ///< most of them
  Place place = {};
  bool is_asked() const { return energy || stress; }
  bool operator==(const AccuracyInput&) const = default;
};

}  // namespace isopatch::app
