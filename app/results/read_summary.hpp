#pragma once

#include <optional>
#include <string>

#include "app/results/run_summary.hpp"

namespace isopatch::app {

/// Of stored results. What is missing in the summary, or of another type, is left out.
/// @param text  of summary.json
/// @return      nothing for a text that is no summary
std::optional<RunSummary> read_summary(const std::string& text);

}  // namespace isopatch::app
