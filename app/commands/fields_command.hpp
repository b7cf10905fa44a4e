#pragma once

#include <filesystem>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

struct FieldsCommand {
  std::filesystem::path results;
  std::string case_name = {};  ///< a load case; "": the first
  std::filesystem::path output;
  int pieces = 0;  ///< as FieldOptions
};
/// Writes the fields of stored results for ParaView.
ExitCode fields_command(const FieldsCommand& command, const Console& console);

void add_fields_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
