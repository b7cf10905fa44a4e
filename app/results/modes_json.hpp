#pragma once

#include <string>
#include <vector>

#include "app/base/warning.hpp"
#include "app/study/study.hpp"
#include "iga/solution/natural_modes.hpp"

namespace isopatch::app {

/// modes.json; SUMMARY.md documents its keys. SI units.
/// @param not_matching  whether some patches do not match: Nitsche's method couples them
std::string modes_json(const Study& study, const iga::NaturalModes& found, bool not_matching,
                       const std::vector<Warning>& warnings);

}  // namespace isopatch::app
