#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/part_picture.hpp"
#include "app/pictures/draw.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

/// Refuses what could not be written before any work is done.
void check_output(const std::filesystem::path& file) {
  if (file.extension() != ".png")
    throw Error(ErrorCode::invalid_argument,
                fmt::format("pictures are written as .png, not as '{}'", file.string()));
  std::error_code none;
  if (std::filesystem::is_directory(file, none))
    throw Error(ErrorCode::io, fmt::format("cannot write {}: it is a directory", file.string()));
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, none))
    throw Error(ErrorCode::io,
                fmt::format("cannot write {}: there is no directory {}", file.string(), folder.string()));
}

}  // namespace

ExitCode render_command(const RenderCommand& command, const Console& console) {
  check_output(command.output);
  const bool has_results = command.input.path.extension() == ".h5";
  const PictureOptions options = parse_picture_options(command.words, has_results);
  ProgressDisplay display(console);
  const Progress progress = display.progress();
  progress("reading", 0);
  const LoadedInput input = load_input(command.input);
  progress("sampling the part", 0);
  const PartPicture composed = part_picture(input, options);
  progress("drawing", 0);
  write_file(command.output, draw(composed.picture));
  display.clear();
  if (!console.quiet)
    console.out << fmt::format("{}: {} x {} pixels, {}\n", command.output.string(), options.size.width,
                               options.size.height, composed.description);
  return ExitCode::ok;
}

}  // namespace isopatch::app
