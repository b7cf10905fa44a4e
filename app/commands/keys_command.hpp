#pragma once

#include <string>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

/// Prints the documentation of the study file.
/// @throws Error invalid_argument  for a topic that is no section and no key
ExitCode keys_command(const std::string& topic, const Console& console);

void add_keys_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
