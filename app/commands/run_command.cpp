#include "app/commands/run_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <variant>

#include "app/commands/write_results.hpp"
#include "app/reports/cutting_page.hpp"
#include "app/results/summary.hpp"
#include "app/run/run_study.hpp"
#include "app/solids/fault_page.hpp"
#include "geometry/brep/solid_error.hpp"
#include "segmentation/decomposition/cutting_error.hpp"

namespace isopatch::app {
namespace {

constexpr const char* run_examples = R"(Examples:
  isopatch run study.toml
  isopatch run study.toml --output /tmp/fine --set discretization.refine=2
  isopatch run study.toml --set load.0.traction='["20 MPa", 0, 0]' --set coupling.method=lagrange
  mpiexec -n 4 isopatch run study.toml               the same figures from four processes
  srun --mpi=pmix -n 4 -c 8 isopatch run study.toml  with Slurm, 8 threads each
  isopatch run study.toml --quiet && jq .results.internal_energy results/summary.json
Writes report.html (open it in a browser), summary.json, results.vtm and others with fields/ (ParaView) and
results.h5 (isopatch report, probe, fields, info).
Files appear whole or not at all, and only after everything has been computed.)";

// Of solids that cannot be made patches the report shows what is wrong. What an earlier run found stays: its
// own report can be made again.
StudyRun solved(const Study& study, const Progress& progress) {
  try {
    return run_study(study, progress);
  } catch (const geometry::SolidError& error) {
    const auto* solids = std::get_if<BlocksInput>(&study.model.source);
    if (!study.options.processes.is_first() || !study.output.report || !solids) throw;
    const std::filesystem::path& directory = study.output.directory;
    const auto* cutting = dynamic_cast<const segmentation::CuttingError*>(&error);
    write_in(directory, "report.html",
             cutting && !cutting->parts().empty() ? cutting_fault_html(*cutting, study.title, study.text)
                                                  : fault_html(*solids, error, study.title, study.text));
    throw Error(error.code(), shown_in(error, directory / "report.html"));
  }
}

}  // namespace

ExitCode run_command(const StudyCommand& command, const Console& console) {
  const Study study = study_of(command);
  const auto folder = taken_folder(study);
  ProgressDisplay display(console);
  StudyRun run = solved(study, display.progress());
  if (!command.processes.is_first()) return ExitCode::ok;
  const std::vector<std::string> files = write_results(study, run, display.progress());
  display.clear();
  for (const Warning& warning : run.built.warnings) console.warn(warning.text);
  if (!console.quiet)
    console.out << summary_text(study, run)
                << fmt::format("  results in        {}: {}\n", study.output.directory.string(),
                               fmt::join(files, ", "));
  return ExitCode::ok;
}

void add_run_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<StudyCommand>();
  add_study_options(
      add_spread_command(app, line, "run", "Solves a study and writes its results", run_examples,
                         [command](const Console& console, const solvers::Processes& processes) {
                           command->processes = processes;
                           return run_command(*command, console);
                         }),
      *command);
}

}  // namespace isopatch::app
