#pragma once

#include <string>

#include "app/study/study.hpp"
#include "iga/solution/natural_modes.hpp"

namespace isopatch::app {

/// modes.json; SUMMARY.md documents its keys. SI units.
std::string modes_json(const Study& study, const iga::NaturalModes& found);

}  // namespace isopatch::app
