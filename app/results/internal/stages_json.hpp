#pragma once

// For .cpp files of this library only, as json_values.hpp is.

#include <vector>

#include "app/base/internal/json_values.hpp"
#include "app/problem/stage_folder.hpp"

namespace isopatch::app {

/// How stages came to their results, as summary.json has it.
Json stages_json(const std::vector<StageReport>& stages);

}  // namespace isopatch::app
