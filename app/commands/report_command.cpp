#include "app/commands/report_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/input_options.hpp"
#include "app/reports/report_page.hpp"
#include "app/results/output_directory.hpp"
#include "app/results/read_summary.hpp"
#include "geometry/base/atomic_file.hpp"
#include "iga/output/result_file.hpp"

namespace isopatch::app {
namespace {

constexpr const char* report_examples = R"(Examples:
  isopatch report results/results.h5                 writes results/report.html
  isopatch report results/results.h5 -o link.html
The page needs no network and no other file; isopatch run writes it too.)";

}  // namespace

ExitCode report_command(const ReportCommand& command, const Console& console) {
  const auto path = command.output.value_or(command.results.parent_path() / "report.html");
  check_writable(path.parent_path().empty() ? "." : path.parent_path());
  ProgressDisplay display(console);
  const auto progress = display.progress();
  progress("reading the results", 0);
  const iga::StoredResult result = iga::read_result(command.results, command.case_name);
  progress("making the report", 0);
  const geometry::MultiPatch model = iga::model_of(result);
  write_file(path, report_html({.field = result.field,
                                .model = model,
                                .study = result.study,
                                .summary_json = summary_of_case(result.summary, result.case_name),
                                .summary = read_summary(result.summary, result.case_name),
                                .stages = read_stages(result.summary, command.results.parent_path())}));
  display.clear();
  if (!console.quiet) console.out << fmt::format("{} written; open it in a browser\n", path.string());
  return ExitCode::ok;
}

void add_report_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<ReportCommand>();
  CLI::App& report =
      add_command(app, line, "report", "Writes the page about stored results", report_examples,
                  [command](const Console& console) { return report_command(*command, console); });
  report.add_option("results", command->results, "A results.h5")->required();
  add_case(report, command->case_name);
  report.add_option("-o,--output", command->output, "The page (default: report.html beside the results)")
      ->type_name("FILE");
}

}  // namespace isopatch::app
