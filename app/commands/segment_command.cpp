#include "app/commands/segment_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/engineering_units.hpp"
#include "app/commands/input_options.hpp"
#include "app/problem/block_file.hpp"
#include "app/problem/cut_solids.hpp"
#include "app/problem/cutting_json.hpp"
#include "app/problem/t_joint_text.hpp"
#include "app/reports/cutting_page.hpp"
#include "app/results/output_directory.hpp"
#include "app/solids/fault_page.hpp"
#include "app/study/segmentation_keys.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/brep/write_brep.hpp"

namespace isopatch::app {
namespace {

constexpr const char* segment_examples = R"(Examples:
  isopatch segment part.step -o blocks
  isopatch segment part.off --length-unit mm -o blocks --time-limit 300
  isopatch segment left.step right.step -o blocks    several solids, one model
Cuts along loops on the boundary, through concave edges first, until all parts are topological hexahedra that meet side to
side. Faces keep their names ("face 3" where they have none) and colours. A study takes them with
file = "blocks/blocks.h5", without cutting again; with file = "part.step" it does all of it by itself.
report.html shows the blocks, drawn apart, and what was done. Where a body is given up, failure.html shows what had been
cut by then, the other bodies are written, and the exit code is 2.)";

constexpr const char* blocks_name = "blocks.h5";
constexpr const char* report_page_name = "report.html";
constexpr const char* failure_page = "failure.html";

BlocksInput input_of(const SegmentCommand& command) {
  BlocksInput input;
  input.files.files = command.solids;
  input.decomposition = segmentation::DecompositionOptions{};
  input.decomposition->time_limit = command.time_limit;
  input.decomposition->t_joints = *find_choice(t_joint_choices(), command.t_joints);
  input.decomposition->method = *find_choice(method_choices(), command.method);
  input.decomposition->blends = *find_choice(blend_choices(), command.blends);
  if (!command.length_unit.empty())
    input.files.length_unit = length_unit(InputFile{{}, {}, command.length_unit});
  set_reading(command.reading, input.files);
  return input;
}

/// "part.step", "part.step and 2 others".
std::string title_of(const SegmentCommand& command) {
  const std::string first = command.solids.front().filename().string();
  const std::size_t others = command.solids.size() - 1;
  return others == 0 ? first : fmt::format("{} and {}", first, counted(others, "other"));
}

/// The bodies cut as far as they can be; a file without sound bodies is shown in failure.html.
CutSolids cut(const BlocksInput& input, const SegmentCommand& command, const Progress& progress) {
  try {
    return try_to_cut_solids(input, progress);
  } catch (const geometry::SolidError& error) {
    const std::filesystem::path page = command.output / failure_page;
    write_file(page, fault_html(input, error, title_of(command), ""));
    throw Error(error.code(), shown_in(error, page));
  }
}

/// Writes the blocks and removes those of an earlier run that made more.
void write_blocks(const std::vector<geometry::BrepFile>& blocks, const std::filesystem::path& folder) {
  std::size_t next = 0;
  for (const geometry::BrepFile& block : blocks)
    geometry::write_brep(folder / block_file_name(next++), block.brep);
  while (std::filesystem::remove(folder / block_file_name(next))) ++next;
}

/// How the blocks meet, or why a study would refuse them.
struct Together {
  std::optional<segmentation::ReadBlocks> blocks;
  std::string refusal;
};

Together tried_together(const CutSolids& solids) {
  try {
    return {put_together(solids), ""};
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    return {std::nullopt, error.what()};
  }
}

/// Writes the file that studies read, or removes that of an earlier run.
void write_block_file(const std::optional<segmentation::ReadBlocks>& blocks,
                      const std::filesystem::path& file) {
  if (blocks)
    write_file(file, block_file_bytes(*blocks));
  else
    std::filesystem::remove(file);
}

std::string files_text(std::size_t blocks, const std::filesystem::path& folder) {
  if (blocks == 0) return "";
  const std::string last = block_file_name(blocks - 1);
  return fmt::format("  {} written to {}\n", blocks == 1 ? last : block_file_name(0) + " to " + last,
                     folder.string());
}

/// Says of each body that was given up why.
ExitCode told_failures(const CutSolids& solids, const std::filesystem::path& page, const Console& console) {
  ExitCode code = ExitCode::ok;
  for (const CutBody& body : solids.bodies) {
    if (!body.failure) continue;
    console.fail(shown_in(*body.failure, page));
    code = ExitCode::wrong_input;
  }
  return code;
}

}  // namespace

ExitCode segment_command(const SegmentCommand& command, const Console& console) {
  const BlocksInput input = input_of(command);
  const OutputFolder folder(command.output);
  ProgressDisplay display(console);
  const CutSolids solids = cut(input, command, display.progress());
  const bool failed = std::any_of(solids.bodies.begin(), solids.bodies.end(),
                                  [](const CutBody& body) { return body.failure.has_value(); });
  const std::vector<geometry::BrepFile> blocks = solids.blocks();
  display.progress()(blocks.empty() ? "writing the page" : "writing blocks and page", 0);
  write_blocks(blocks, command.output);
  const Together together = failed ? Together{} : tried_together(solids);
  write_block_file(together.blocks, command.output / blocks_name);
  const std::filesystem::path page = command.output / (failed ? failure_page : report_page_name);
  write_file(page, cutting_html(
                       solids, title_of(command),
                       together.blocks ? t_joint_texts(together.blocks->model) : std::vector<std::string>{}));
  std::filesystem::remove(command.output / (failed ? report_page_name : failure_page));
  display.clear();
  for (const std::string& warning : solids.warnings) console.warn(warning);
  if (!together.refusal.empty())
    console.warn(fmt::format("{} is not written, since a study would refuse the blocks: {}", blocks_name,
                             together.refusal));
  if (command.json)
    console.out << cutting_json_text(solids);
  else if (!console.quiet)
    console.out << cutting_text(solids) << files_text(blocks.size(), command.output)
                << (failed ? ""
                           : fmt::format("  {}{} shows the blocks\n",
                                         together.blocks ? "blocks.h5 for studies, " : "", page.string()));
  return told_failures(solids, page, console);
}

void add_segment_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<SegmentCommand>();
  CLI::App& segment =
      add_command(app, line, "segment", "Cuts solids into topological hexahedra", segment_examples,
                  [command](const Console& console) { return segment_command(*command, console); });
  segment
      .add_option("solids", command->solids,
                  "Solids: .step, .stp, .p21, .iges, .igs, .brep, .brp, .xml (G+Smo), .off")
      ->required();
  segment.add_option("-o,--output", command->output, "Folder of the blocks (.step) and the page")
      ->required()
      ->type_name("FOLDER");
  segment.add_option("--length-unit", command->length_unit,
                     "What one unit measures, in formats that do not say it; default: m");
  add_reading(segment, command->reading);
  segment
      .add_option("--time-limit", command->time_limit, "Seconds of computing that a body may take to be cut")
      ->check(above_zero())
      ->capture_default_str();
  segment
      .add_option("--t-joints", command->t_joints,
                  "Sides that meet others in parts: remove them by further cuts, or keep them")
      ->check(CLI::IsMember(names(t_joint_choices())))
      ->capture_default_str();
  segment
      .add_option("--method", command->method,
                  "How blocks are looked for: by sweeping where possible, or by cuts alone")
      ->check(CLI::IsMember(names(method_choices())))
      ->capture_default_str();
  segment
      .add_option("--blends", command->blends,
                  "Rounds that keep a body from being swept: keep them, or remove them")
      ->check(CLI::IsMember(names(blend_choices())))
      ->capture_default_str();
  segment.add_flag("--json", command->json, "JSON instead of text");
}

}  // namespace isopatch::app
