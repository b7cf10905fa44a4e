#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/results/run_summary.hpp"

namespace isopatch::app {

/// Of stored results. What is missing in the summary, or of another type, is left out.
/// @param text       of summary.json
/// @param case_name  a load case or combination whose results are wanted; "": the first
/// @return           nothing for a text that is no summary
std::optional<RunSummary> read_summary(const std::string& text, const std::string& case_name = "");

/// The stages from a file to patches, whose files count from the folder of the results; none of a model that
/// had patches.
std::vector<StageReport> read_stages(const std::string& text, const std::filesystem::path& folder);

/// The summary as a page about one load case shows it: the results, probes, solver and loads of the case in
/// the place of the first's, and its name as `case`. The text itself where there are no cases.
std::string summary_of_case(const std::string& text, const std::string& case_name);

}  // namespace isopatch::app
