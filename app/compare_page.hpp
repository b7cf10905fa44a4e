#pragma once

#include <string>
#include <vector>

#include "app/compare_couplings.hpp"
#include "app/study.hpp"

namespace isopatch::app {

/// What the page of a comparison shows, as JSON: tables, plots, and the part with the tractions on its
/// interfaces and the places of the largest differences.
/// @param finest  the last of the levels
/// @param levels  at least one, the finest last
std::string compare_page_data(const Study& study, const ComparedStudy& finest,
                              const std::vector<CouplingComparison>& levels);

}  // namespace isopatch::app
