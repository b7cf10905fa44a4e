#include "app/commands/fields_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/input_options.hpp"
#include "app/results/output_directory.hpp"
#include "app/results/read_summary.hpp"
#include "app/results/write_fields.hpp"
#include "iga/output/result_file.hpp"

namespace isopatch::app {
namespace {

constexpr const char* fields_examples = R"(Examples:
  isopatch fields results/results.h5 --output paraview
  isopatch fields results/results.h5 --output fine --pieces 8
Writes results.vtm (open it in ParaView; all filters work on it), results_boundaries.vtm and results_exact.vtm
(the smooth surface), with their parts in fields/.)";

}  // namespace

ExitCode fields_command(const FieldsCommand& command, const Console& console) {
  const OutputFolder folder(command.output);
  ProgressDisplay display(console);
  const iga::StoredResult result = iga::read_result(command.results, command.case_name);
  const geometry::MultiPatch model = iga::model_of(result);
  const WrittenFields written =
      write_fields(result.field, model,
                   face_groups(model, read_summary(result.summary, result.case_name).value_or(RunSummary{})),
                   {.pieces = command.pieces}, command.output, display.progress());
  display.clear();
  for (const auto& warning :
       {borrowed_warning(written.borrowed, model.size()), fit_warning(written.fit, model.size())})
    if (warning) console.warn(warning->text);
  if (!console.quiet)
    console.out << fmt::format("{} files in {}; open results.vtm in ParaView\n", written.files,
                               command.output.string());
  return ExitCode::ok;
}

void add_fields_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<FieldsCommand>();
  CLI::App& fields =
      add_command(app, line, "fields", "Writes the fields of stored results for ParaView", fields_examples,
                  [command](const Console& console) { return fields_command(*command, console); });
  fields.add_option("results", command->results, "A results.h5")->required();
  fields.add_option("-o,--output", command->output, "Directory for results.vtm and fields/")
      ->required()
      ->type_name("DIR");
  add_case(fields, command->case_name);
  fields
      .add_option("--pieces", command->pieces,
                  "Straight hexahedra per element and direction (default: 4, fewer in large models, more "
                  "where von Mises stress needs them)")
      ->check(CLI::Range(1, 32))
      ->type_name("N");
}

}  // namespace isopatch::app
