#include <fmt/format.h>

#include "app/base/exit_code.hpp"
#include "app/commands/commands.hpp"
#include "app/reports/parameterization_scene.hpp"
#include "app/results/output_directory.hpp"
#include "app/solids/fault_page.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/io/write_gismo_xml.hpp"

namespace isopatch::app {
namespace {

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
  input.options.method = command.method == "paper" ? segmentation::ParameterizationMethod::paper
                                                   : segmentation::ParameterizationMethod::shared;
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
                << fmt::format("  {} patch{}, {} interface{}, lengths in m, written to {}\n",
                               model.patch_count(), model.patch_count() == 1 ? "" : "es",
                               model.interfaces().size(), model.interfaces().size() == 1 ? "" : "s",
                               command.output.string());
  return made.report.usable() ? ExitCode::ok : ExitCode::failed;
}

}  // namespace isopatch::app
