#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

struct ModesCommand {
  std::filesystem::path study;
  std::vector<std::string> overrides;
  std::optional<std::filesystem::path> output;
};
/// Natural frequencies and shapes of a study's part: a table, modes.json and fields of the shapes.
ExitCode modes_command(const ModesCommand& command, const Console& console,
                       const solvers::Processes& processes);

void add_modes_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
