#pragma once

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"
#include "app/results/load_input.hpp"

namespace isopatch::app {

struct InfoCommand {
  InputFile input;
  bool json = false;
  bool all = false;
};
/// Describes a model: patches, interfaces, faces, quality.
ExitCode info_command(const InfoCommand& command, const Console& console);

void add_info_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
