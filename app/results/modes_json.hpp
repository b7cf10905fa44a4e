#pragma once

#include <string>
#include <vector>

#include "app/base/warning.hpp"
#include "app/study/study.hpp"
#include "iga/solution/natural_modes.hpp"

namespace isopatch::app {

/// modes.json; SUMMARY.md documents its keys. SI units.
std::string modes_json(const Study& study, const iga::NaturalModes& found,
                       const std::vector<Warning>& warnings);

}  // namespace isopatch::app
