#pragma once

#include <filesystem>
#include <string>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"
#include "segmentation/reconstruction/reconstruction_options.hpp"

namespace isopatch::app {

struct ReconstructCommand {
  std::filesystem::path triangles;
  std::filesystem::path output;     ///< a folder
  std::string length_unit;          ///< as of InputFile
  std::string method = "carriers";  ///< or "angles"
  segmentation::ReconstructionOptions options;
  bool json = false;
};
/// Makes a solid of triangles and writes it as a STEP file, with a report.
ExitCode reconstruct_command(const ReconstructCommand& command, const Console& console);

void add_reconstruct_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
