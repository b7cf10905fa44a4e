#include "app/commands/convert_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/base/engineering_units.hpp"
#include "app/problem/read_model_file.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/io/write_gismo_xml.hpp"

namespace isopatch::app {
namespace {

constexpr const char* convert_examples = R"(Examples:
  isopatch convert model.g2 --output model.xml
  isopatch convert part.mesh --output part.xml)";

}  // namespace

ExitCode convert_command(const ConvertCommand& command, const Console& console) {
  const geometry::MultiPatch model = geometry::connect(read_model_file(command.input, false));
  write_file(command.output, geometry::to_gismo_xml(model));
  if (!console.quiet)
    console.out << fmt::format("{}, {} written to {}\n", counted(model.patch_count(), "patch", "patches"),
                               counted(model.interfaces().size(), "interface"), command.output.string());
  return ExitCode::ok;
}

void add_convert_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<ConvertCommand>();
  CLI::App& convert =
      add_command(app, line, "convert", "Writes patches as G+Smo XML", convert_examples,
                  [command](const Console& console) { return convert_command(*command, console); });
  convert.add_option("input", command->input, "Patches (.xml, .g2, .mesh)")->required();
  convert.add_option("-o,--output", command->output, "The new file (.xml)")->required()->type_name("FILE");
}

}  // namespace isopatch::app
