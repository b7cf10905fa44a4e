#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"
#include "app/results/load_input.hpp"
#include "app/study/blocks_input.hpp"

namespace isopatch::app {

struct ParameterizeCommand {
  std::vector<std::filesystem::path> blocks;
  std::string pairs;        ///< a file, or "" to find them from the geometry
  std::string length_unit;  ///< as of InputFile
  CadReading reading;
  std::string method = "shared";
  BlocksInput input;             ///< the options; files are filled in
  std::filesystem::path output;  ///< .xml
  std::filesystem::path report;  ///< .html, or "" for none
};
/// Makes patches of topological hexahedra and writes them as G+Smo XML; `failed` if one is not certified or
/// deviates too far, after writing. The report shows the patches or, where the input is bad, what is wrong
/// with it.
ExitCode parameterize_command(const ParameterizeCommand& command, const Console& console);

void add_parameterize_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
