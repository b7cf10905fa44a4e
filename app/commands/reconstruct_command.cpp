#include "app/commands/reconstruct_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/problem/reconstructed_solids.hpp"
#include "app/problem/reconstruction_text.hpp"
#include "app/results/load_input.hpp"
#include "app/results/output_directory.hpp"
#include "app/study/reconstruction_keys.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/write_brep.hpp"

namespace isopatch::app {
namespace {

constexpr const char* reconstruct_examples = R"(Examples:
  isopatch reconstruct part.stl -o part --length-unit mm
  isopatch reconstruct scan.obj -o part --tolerance 1e-5 --json
Finds the planes, cylinders, cones, spheres and tori that the vertices lie on, makes them parallel, coaxial or of equal radii
where they are so nearly, and bounds them where they meet. Faces are called plane_1, cylinder_1, ..., each kind in the
order of area. Writes FILE.step and reconstruction.json. A study takes triangles with file = "part.stl".)";

constexpr const char* report_name = "reconstruction.json";

std::optional<double> metres_of(const ReconstructCommand& command) {
  if (command.length_unit.empty()) return std::nullopt;
  return length_unit(InputFile{{}, {}, command.length_unit});
}

}  // namespace

ExitCode reconstruct_command(const ReconstructCommand& command, const Console& console) {
  segmentation::ReconstructionOptions options = command.options;
  options.method = *find_choice(region_method_choices(), command.method);
  segmentation::validate(options);
  const OutputFolder folder(command.output);
  ProgressDisplay display(console);
  const segmentation::Reconstruction made =
      reconstructed(command.triangles, metres_of(command), options, display.progress());
  const std::filesystem::path solid = command.output / (command.triangles.stem().string() + ".step");
  display.progress()("writing the solid", 0);
  geometry::write_brep(solid, made.brep);
  write_file(command.output / report_name, reconstruction_json_text(made));
  display.clear();
  for (const std::string& remark : made.report.remarks) console.warn(remark);
  if (command.json)
    console.out << reconstruction_json_text(made);
  else if (!console.quiet)
    console.out << reconstruction_text(made)
                << fmt::format("  {} and {} written to {}\n", solid.filename().string(), report_name,
                               command.output.string());
  return ExitCode::ok;
}

void add_reconstruct_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<ReconstructCommand>();
  CLI::App& reconstruct =
      add_command(app, line, "reconstruct", "Makes a solid of triangles", reconstruct_examples,
                  [command](const Console& console) { return reconstruct_command(*command, console); });
  reconstruct.add_option("triangles", command->triangles, "Triangles: .stl, .obj, .ply, .3mf, .off")
      ->required()
      ->type_name("FILE");
  reconstruct.add_option("-o,--output", command->output, "Folder of the solid (.step) and the report")
      ->required()
      ->type_name("FOLDER");
  reconstruct.add_option("--length-unit", command->length_unit,
                         "What one unit of the file measures; default: what a .3mf says, m otherwise");
  reconstruct
      .add_option("--tolerance", command->options.tolerance,
                  "Largest distance of vertices from surfaces, share of the size, up to 0.01")
      ->capture_default_str();
  reconstruct
      .add_option("--method", command->method,
                  "How triangles are put together: by surfaces, or by angles alone")
      ->check(CLI::IsMember(names(region_method_choices())))
      ->capture_default_str();
  reconstruct
      .add_option("--time-limit", command->options.time_limit,
                  "Seconds of the processor after which it is given up")
      ->capture_default_str();
  reconstruct.add_flag("--remove-blends", command->options.remove_blends,
                       "Rounds along freeform walls between parallel planes are left out");
  reconstruct.add_flag("--json", command->json, "JSON instead of text");
}

}  // namespace isopatch::app
