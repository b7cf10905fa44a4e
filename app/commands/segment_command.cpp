#include "app/commands/segment_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/input_options.hpp"
#include "app/problem/cut_solids.hpp"
#include "app/problem/cutting_json.hpp"
#include "app/results/output_directory.hpp"
#include "geometry/brep/write_brep.hpp"

namespace isopatch::app {
namespace {

constexpr const char* segment_examples = R"(Examples:
  isopatch segment part.step -o blocks
  isopatch segment part.off --length-unit mm -o blocks --time-limit 300
Cuts along loops on the boundary, through concave edges first, until all parts are topological hexahedra that meet side to
side. Faces keep their names ("face 3" where they have none) and colours. The blocks can be given to a study:
blocks = ["blocks/block_0.step", ...]; a study with file = "part.step" does all of it by itself.)";

}  // namespace

ExitCode segment_command(const SegmentCommand& command, const Console& console) {
  BlocksInput input;
  input.files.files = {command.solid};
  input.decomposition = segmentation::DecompositionOptions{};
  input.decomposition->time_limit = command.time_limit;
  if (!command.length_unit.empty())
    input.files.length_unit = length_unit(InputFile{{}, {}, command.length_unit});
  set_reading(command.reading, input.files);
  const OutputFolder folder(command.output);
  ProgressDisplay display(console);
  const CutSolids solids = cut_solids(input, display.progress());
  const auto block = [&](std::size_t b) { return command.output / fmt::format("block_{}.step", b); };
  for (std::size_t b = 0; b < solids.blocks.size(); ++b)
    geometry::write_brep(block(b), solids.blocks[b].brep);
  // Of an earlier run that made more.
  for (std::size_t b = solids.blocks.size(); std::filesystem::remove(block(b)); ++b) {
  }
  display.clear();
  for (const std::string& warning : solids.warnings) console.warn(warning);
  if (command.json)
    console.out << cutting_json_text(solids);
  else if (!console.quiet)
    console.out << cutting_text(solids)
                << fmt::format("  {} written to {}\n",
                               solids.blocks.size() == 1
                                   ? "block_0.step"
                                   : fmt::format("block_0.step to block_{}.step", solids.blocks.size() - 1),
                               command.output.string());
  return ExitCode::ok;
}

void add_segment_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<SegmentCommand>();
  CLI::App& segment =
      add_command(app, line, "segment", "Cuts solids into topological hexahedra", segment_examples,
                  [command](const Console& console) { return segment_command(*command, console); });
  segment
      .add_option("solid", command->solid,
                  "Solids: .step, .stp, .p21, .iges, .igs, .brep, .brp, .xml (G+Smo), .off")
      ->required();
  segment.add_option("-o,--output", command->output, "Folder of the blocks (.step)")
      ->required()
      ->type_name("FOLDER");
  segment.add_option("--length-unit", command->length_unit,
                     "What one unit measures, in formats that do not say it; default: m");
  add_reading(segment, command->reading);
  segment.add_option("--time-limit", command->time_limit, "Seconds that a body may take to be cut")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  segment.add_flag("--json", command->json, "JSON instead of text");
}

}  // namespace isopatch::app
