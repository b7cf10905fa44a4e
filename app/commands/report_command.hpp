#pragma once

#include <filesystem>
#include <optional>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

struct ReportCommand {
  std::filesystem::path results;
  std::string case_name = {};                   ///< a load case; "": the first
  std::optional<std::filesystem::path> output;  ///< default: report.html beside the results
};
/// Writes the page about stored results.
ExitCode report_command(const ReportCommand& command, const Console& console);

void add_report_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
