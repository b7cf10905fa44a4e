#include <fmt/format.h>

#include "app/base/exit_code.hpp"
#include "app/commands/commands.hpp"
#include "app/pictures/draw.hpp"
#include "app/render/part_picture.hpp"
#include "app/render/solid_picture.hpp"
#include "app/study/solid_file.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

/// Refuses what could not be written before any work is done.
void check_output(const std::filesystem::path& file, bool of_solid) {
  if (file.extension() != ".png" && !(of_solid && file.extension() == ".svg"))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("pictures are written as .png{}, not as '{}'",
                            of_solid ? ", edge graphs of solids as .svg" : "", file.string()));
  std::error_code none;
  if (std::filesystem::is_directory(file, none))
    throw Error(ErrorCode::io, fmt::format("cannot write {}: it is a directory", file.string()));
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, none))
    throw Error(ErrorCode::io,
                fmt::format("cannot write {}: there is no directory {}", file.string(), folder.string()));
}

/// The solids that are asked for.
std::vector<SolidReport> chosen_solids(const RenderCommand& command, const std::vector<SolidReport>& solids) {
  if (!command.solid) return solids;
  const int count = static_cast<int>(solids.size()), wanted = *command.solid;
  if (wanted < 0 || wanted >= count)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--solid {}: {} holds {} solid{}, counted from 0", wanted,
                            command.input.path.string(), count, count == 1 ? "" : "s"));
  return {solids[static_cast<std::size_t>(wanted)]};
}

std::string graph_of(const std::vector<SolidReport>& solids, const std::string& title) {
  if (solids.size() > 1)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} holds {} solids; an edge graph is drawn of one: choose it by --solid 0 to "
                            "--solid {}",
                            title, solids.size(), solids.size() - 1));
  return solid_graph_svg(solids[0], title);
}

ExitCode render_solid(const RenderCommand& command, const Console& console) {
  const PictureOptions options = parse_picture_options(command.words, false);
  ProgressDisplay display(console);
  const Progress progress = display.progress();
  const LoadedSolids loaded = load_solids(command.input, progress);
  const std::vector<SolidReport> solids = chosen_solids(command, loaded.bodies);
  progress("drawing", 0);
  const std::string title = command.input.path.filename().string();
  std::string description = "edge graph";
  if (command.output.extension() == ".svg") {
    write_file(command.output, graph_of(solids, title));
  } else {
    const PartPicture composed = solids_picture(solids, options, title);
    write_file(command.output, draw(composed.picture));
    description =
        fmt::format("{} x {} pixels, {}", options.size.width, options.size.height, composed.description);
  }
  display.clear();
  for (const std::string& warning : loaded.warnings)
    console.warn(fmt::format("{}: {}", command.input.path.string(), warning));
  if (!console.quiet) console.out << fmt::format("{}: {}\n", command.output.string(), description);
  return ExitCode::ok;
}

}  // namespace

ExitCode render_command(const RenderCommand& command, const Console& console) {
  const bool of_solid = is_solid_file(command.input.path);
  check_output(command.output, of_solid);
  if (of_solid) return render_solid(command, console);
  if (command.solid)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--solid chooses one of the solids of a CAD file; {} holds patches",
                            command.input.path.string()));
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
