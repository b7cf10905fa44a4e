#pragma once

#include <filesystem>
#include <optional>
#include <string>

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
};
/// Values at a point or a parameter of stored results.
ExitCode probe_command(const ProbeCommand& command, const Console& console);

void add_probe_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
