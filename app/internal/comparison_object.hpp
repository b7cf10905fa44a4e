#pragma once

#include <vector>

#include "app/compare_couplings.hpp"
#include "app/internal/json_values.hpp"

namespace isopatch::app {

/// The content of compare.json.
Json comparison_object(const Study& study, const std::vector<CouplingComparison>& levels);

}  // namespace isopatch::app
