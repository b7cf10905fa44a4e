#pragma once

#include <filesystem>
#include <optional>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"
#include "app/render/picture_options.hpp"
#include "app/results/load_input.hpp"

namespace isopatch::app {

struct RenderCommand {
  InputFile input;
  std::filesystem::path output;  ///< .png
  std::optional<int> solid;      ///< of a file with several; all of them if not given
  PictureWords words;
};
/// Draws a model or results as a picture.
ExitCode render_command(const RenderCommand& command, const Console& console);

void add_render_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
