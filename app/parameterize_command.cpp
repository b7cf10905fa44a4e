#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/output_directory.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/io/write_gismo_xml.hpp"

namespace isopatch::app {

ExitCode parameterize_command(const ParameterizeCommand& command, const Console& console) {
  BlocksInput input = command.input;
  input.files.files = command.blocks;
  if (!command.pairs.empty()) input.files.pairs = command.pairs;
  input.files.length_unit = length_unit({.length_unit = command.length_unit});
  input.options.method = command.method == "paper" ? segmentation::ParameterizationMethod::paper
                                                   : segmentation::ParameterizationMethod::shared;
  const auto folder = command.output.parent_path();
  check_writable(folder.empty() ? "." : folder);
  ProgressDisplay display(console);
  const segmentation::Parameterization made = parameterized(input, display.progress());
  const geometry::MultiPatch model = geometry::connect(made.patches);
  write_file(command.output, geometry::to_gismo_xml(model));
  display.clear();
  for (const std::string& complaint : made.report.complaints()) console.warn(complaint);
  if (!console.quiet)
    console.out << parameterization_text(made.report)
                << fmt::format("  {} patches, {} interfaces, lengths in m, written to {}\n",
                               model.patch_count(), model.interfaces().size(), command.output.string());
  return made.report.usable() ? ExitCode::ok : ExitCode::failed;
}

}  // namespace isopatch::app
