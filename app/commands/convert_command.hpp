#pragma once

#include <filesystem>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

struct ConvertCommand {
  std::filesystem::path input;
  std::filesystem::path output;
};
/// Writes patches as G+Smo XML.
ExitCode convert_command(const ConvertCommand& command, const Console& console);

void add_convert_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
