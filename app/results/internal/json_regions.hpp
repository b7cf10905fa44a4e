#pragma once

// For .cpp files of this folder only: third-party types stay out of the headers that others include.

#include <vector>

#include "app/base/internal/json_values.hpp"
#include "app/problem/applied_region.hpp"

namespace isopatch::app {

/// Supports and loads as summary.json has them; defined in summary.cpp.
Json supports_json(const std::vector<AppliedRegion>& supports);
Json loads_json(const std::vector<AppliedRegion>& loads);

}  // namespace isopatch::app
