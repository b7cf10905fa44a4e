#include "app/commands/parameterize_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/base/engineering_units.hpp"
#include "app/commands/input_options.hpp"
#include "app/problem/parameterized_model.hpp"
#include "app/reports/parameterization_scene.hpp"
#include "app/results/output_directory.hpp"
#include "app/solids/fault_page.hpp"
#include "app/study/parameterization_keys.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/io/write_gismo_xml.hpp"

namespace isopatch::app {
namespace {

constexpr const char* parameterize_examples = R"(Examples:
  isopatch parameterize block.step -o patches.xml
  isopatch parameterize part*.xml --pairs pairs.txt --length-unit '225 mm' -o patches.xml
  isopatch parameterize part*.xml -o patches.xml --tolerance 1e-5
Each solid must be a topological hexahedron: 8 vertices, 12 edges, 6 faces with four edges each. Prints how far the
patches are from the solids and how good they are. Exit code 1 if one is folded or deviates too far.)";

void check_folder(const std::filesystem::path& file) {
  const auto folder = file.parent_path();
  check_writable(folder.empty() ? "." : folder);
}

segmentation::Parameterization patches_of(const BlocksInput& input, const std::filesystem::path& report,
                                          const Progress& progress) {
  try {
    return parameterized(input, progress);
  } catch (const geometry::SolidError& error) {
    if (report.empty()) throw;
    write_file(report, fault_html(input, error, report.stem().string(), ""));
    throw Error(error.code(), shown_in(error, report));
  }
}

}  // namespace

ExitCode parameterize_command(const ParameterizeCommand& command, const Console& console) {
  BlocksInput input = command.input;
  input.files.files = command.blocks;
  if (!command.pairs.empty()) input.files.pairs = command.pairs;
  if (!command.length_unit.empty())
    input.files.length_unit = length_unit(InputFile{{}, {}, command.length_unit});
  set_reading(command.reading, input.files);
  input.options.method = *find_choice(parameterization_methods(), command.method);
  input.options.names = {"--max-spans", "--tolerance"};
  check_folder(command.output);
  if (!command.report.empty()) check_folder(command.report);
  ProgressDisplay display(console);
  const segmentation::Parameterization made = patches_of(input, command.report, display.progress());
  const geometry::MultiPatch model = geometry::connect(made.patches);
  write_file(command.output, geometry::to_gismo_xml(model));
  if (!command.report.empty())
    write_file(command.report, parameterization_html(made.report, model, command.report.stem().string()));
  display.clear();
  for (const std::string& complaint : made.report.complaints()) console.warn(complaint);
  if (!console.quiet)
    console.out << parameterization_text(made.report)
                << fmt::format("  {}, {}, lengths in m, written to {}\n",
                               counted(model.patch_count(), "patch", "patches"),
                               counted(model.interfaces().size(), "interface"), command.output.string());
  return made.report.usable() ? ExitCode::ok : ExitCode::failed;
}

void add_parameterize_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<ParameterizeCommand>();
  CLI::App& parameterize =
      add_command(app, line, "parameterize", "Makes patches of solids that are topological hexahedra",
                  parameterize_examples,
                  [command](const Console& console) { return parameterize_command(*command, console); });
  parameterize
      .add_option("blocks", command->blocks,
                  "Solids: .step, .stp, .p21, .iges, .igs, .brep, .brp, .xml (G+Smo), .off")
      ->required();
  parameterize.add_option("-o,--output", command->output, "The patches (.xml)")
      ->required()
      ->type_name("FILE");
  parameterize
      .add_option("--report", command->report,
                  "A page with the patches by quality and deviation, or with what is wrong with the solids")
      ->type_name("FILE");
  parameterize.add_option("--pairs", command->pairs, "How blocks meet; default: found from the geometry")
      ->type_name("FILE");
  parameterize.add_option("--length-unit", command->length_unit,
                          "What one unit measures, in formats that do not say it; default: m");
  add_reading(parameterize, command->reading);
  parameterize
      .add_option("--tolerance", command->input.options.fit.tolerance,
                  "Largest deviation, share of the size, 1e-8 to 0.1")
      ->capture_default_str();
  segmentation::FitOptions& fit = command->input.options.fit;
  parameterize.add_option("--degree", fit.degree, "Of the patches, 2 to 8")->capture_default_str();
  parameterize
      .add_option("--max-spans", fit.max_spans,
                  "Most knot spans along any direction of a patch, up to 1024; eight times the spans that "
                  "the solid's own splines or turns ask for if that is more")
      ->capture_default_str();
  parameterize
      .add_option("--start-spans", fit.start_spans, "Knot spans along every direction before any is halved")
      ->capture_default_str();
  parameterize
      .add_option("--wanted-quality", command->input.options.wanted_quality,
                  "Patches whose smallest scaled Jacobian is below it are optimized")
      ->capture_default_str();
  parameterize.add_flag("!--no-optimize", command->input.options.optimize,
                        "Moves no control points where a patch is folded or poor, only reports it");
  parameterize
      .add_option("--same-point", command->input.files.assembly.same_point,
                  "Points of two blocks this close, as a share of the size, are one")
      ->capture_default_str();
  parameterize.add_option("--method", command->method, "shared, or paper for comparison")
      ->check(CLI::IsMember(names(parameterization_methods())))
      ->capture_default_str();
}

}  // namespace isopatch::app
