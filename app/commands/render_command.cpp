#include "app/commands/render_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/base/engineering_units.hpp"
#include "app/commands/input_options.hpp"
#include "app/pictures/draw.hpp"
#include "app/render/part_picture.hpp"
#include "app/render/solid_picture.hpp"
#include "app/solids/solid_input.hpp"
#include "app/study/file_kind.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

constexpr const char* render_examples = R"(Examples:
  isopatch render results/results.h5 -o link.png     von Mises stress on the deformed shape
  isopatch render results/results.h5 -o u.png --field displacement --component y --view front
  isopatch render results/results.h5 -o s.png --range '0,300 MPa' --deformation 1 --edges elements
  isopatch render results/results.h5 -o in.png --clip 'z=6 mm' --view top
  isopatch render study.toml -o model.png            the study's model, coloured by patch
  isopatch render study.toml -o held.png --field conditions    faces of its supports blue, of its loads red
  isopatch render part.step -o part.png              a CAD solid: convex edges dark, others red, flat ones grey
  isopatch render part.step -o graph.svg             its edge graph, drawn in the plane
  isopatch render parts.step -o one.png --solid 1    one of several solids; without --solid all of them
Without --range the colours span the values of 99.9 % of the surface (--percentile), so that a singular corner
does not take them all; the largest value stands below the bar. Needs an X display; where there is none, Xvfb
(Debian package xvfb) is started for the time of drawing.)";

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
                fmt::format("--solid {}: {} holds {}, counted from 0", wanted, command.input.path.string(),
                            counted(count, "solid")));
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
  const FileKind kind = kind_of(command.input.path);
  const bool of_solid = holds_solids(kind);
  check_output(command.output, of_solid);
  if (of_solid) return render_solid(command, console);
  if (command.solid)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--solid chooses one of the solids of a CAD file; {} holds patches",
                            command.input.path.string()));
  const bool has_results = kind == FileKind::results;
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

void add_render_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<RenderCommand>();
  CLI::App& render =
      add_command(app, line, "render", "Draws a model or results as a picture", render_examples,
                  [command](const Console& console) { return render_command(*command, console); });
  PictureWords& words = command->words;
  const auto option = [&](const char* name, auto& target, const char* meaning, const char* type) {
    return render.add_option(name, target, meaning)->type_name(type);
  };
  add_input(render, command->input);
  add_case(render, command->input.case_name);
  option("-o,--output", command->output, "The picture (.png), or of a solid's edge graph (.svg)", "FILE")
      ->required();
  option("--field", words.field,
         "von_mises, displacement, patch, jacobian, conditions (supports and loads of a study) or none; "
         "default: "
         "von_mises for results, else patch",
         "NAME");
  option("--component", words.component, "x, y or z of the displacement; default: its length", "AXIS");
  option("--range", words.range, "The values of the first and the last colour, SI or with units", "LOW,HIGH");
  option("--percentile", words.percentile, "How much of the surface the range holds without --range, %", "P")
      ->capture_default_str();
  option("--deformation", words.deformation, "Factor of the displacement in the picture; auto: well visible",
         "FACTOR")
      ->capture_default_str();
  option("--view", words.view,
         "iso, front, back, left, right, top, bottom, or X,Y,Z from the part to the eye", "VIEW")
      ->capture_default_str();
  option("--up", words.up, "What points upwards: x, y, z or X,Y,Z; default: z, along z y", "AXIS");
  option("--zoom", words.zoom, "Above 1: larger than the picture", "F")->capture_default_str();
  option("--size", words.size, "Pixels", "WxH")->capture_default_str();
  option("--edges", words.edges, "Lines: patches, elements or none", "NAME")->capture_default_str();
  option("--clip", words.clip, "Cuts the undeformed part: 'x=20 mm' keeps what lies below", "AXIS=POSITION");
  option("--solid", command->solid, "Draws one solid of a file with several, from 0 as info counts them",
         "N");
  option("--caption", words.caption, "Instead of title and deformation; '' for none", "TEXT");
  render.add_flag("--transparent-background", words.transparent, "No white behind the part");
  render.add_flag("--no-bar", words.no_bar, "No colour bar");
}

}  // namespace isopatch::app
