#pragma once

#include <string>
#include <vector>

#include "app/run/compare_couplings.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// compare.html: tables, plots, and the part with the tractions on its interfaces and the places of the
/// largest differences.
/// @param finest  the last of the levels
/// @param levels  at least one, the finest last
/// @param json    text of compare.json
/// @cost  that of sample_part
std::string compare_html(const Study& study, const ComparedStudy& finest,
                         const std::vector<CouplingComparison>& levels, const std::string& json);

}  // namespace isopatch::app
