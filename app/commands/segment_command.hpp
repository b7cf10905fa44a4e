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

struct SegmentCommand {
  std::vector<std::filesystem::path> solids;
  std::filesystem::path output;  ///< a folder
  std::string length_unit;       ///< as of InputFile
  CadReading reading;
  std::string t_joints = "remove";                                      ///< or "keep"
  std::string method = "automatic";                                     ///< or "cuts"
  std::string blends = "keep";                                          ///< or "remove"
  double time_limit = segmentation::DecompositionOptions{}.time_limit;  ///< s
  bool json = false;
};
/// Cuts solids into topological hexahedra and writes them as STEP files, one a block.
ExitCode segment_command(const SegmentCommand& command, const Console& console);

void add_segment_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
