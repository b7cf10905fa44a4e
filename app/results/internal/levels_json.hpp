#pragma once

// For .cpp files of this folder only: third-party types stay out of the headers that others include.

#include <vector>

#include "app/base/internal/json_values.hpp"
#include "app/run/run_study.hpp"

namespace isopatch::app {

/// Keys `levels`, `convergence` and `accuracy` of summary.json; defined in level_report.cpp.
Json levels_json(const std::vector<RunLevel>& levels);
Json accuracy_json(const AccuracyOutcome& accuracy);
Json convergence_json(const std::vector<RunLevel>& levels);

}  // namespace isopatch::app
