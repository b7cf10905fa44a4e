#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

struct ProbeCommand {
  std::filesystem::path results;
  std::string case_name = {};  ///< a load case; "": the first
  std::string point;           ///< "0.1,0,20 mm"
  std::optional<int> patch;
  std::string parameter;  ///< ".5,.5,1"
  bool json = false;
  std::vector<std::string> line;                ///< both ends, as points; empty: none
  int count = 101;                              ///< of places on the line
  std::optional<std::filesystem::path> places;  ///< a list of points
};
/// Values at a point or a parameter of stored results, or at many as CSV.
ExitCode probe_command(const ProbeCommand& command, const Console& console);

void add_probe_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
