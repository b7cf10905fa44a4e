#include "app/commands/run_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <variant>

#include "app/commands/write_results.hpp"
#include "app/reports/cutting_page.hpp"
#include "app/results/summary_text.hpp"
#include "app/run/run_levels.hpp"
#include "app/solids/fault_page.hpp"
#include "geometry/brep/solid_error.hpp"
#include "segmentation/decomposition/cutting_error.hpp"

namespace isopatch::app {
namespace {

constexpr const char* run_examples = R"(Examples:
  isopatch run study.toml
  isopatch run study.toml --output /tmp/fine --set discretization.refine=2
  isopatch run study.toml --set load.0.traction='["20 MPa", 0, 0]' --set coupling.method=lagrange
  isopatch run study.toml --levels 3                 how energy, stresses and errors converge
  mpiexec -n 4 isopatch run study.toml               the same figures from four processes
  srun --mpi=pmix -n 4 -c 8 isopatch run study.toml  with Slurm, 8 threads each
  isopatch run study.toml --quiet && jq .results.internal_energy results/summary.json
Writes report.html (open it in a browser), summary.json, results.vtm and others with fields/ (ParaView) and
results.h5 (isopatch report, probe, fields, info).
Files appear whole or not at all, and only after everything has been computed.)";

/// What `isopatch run` takes.
struct RunOptions {
  StudyCommand study;
  int levels = 1;
};

// So that a level is not lost with the next. What writing adds to a run is for that file alone: it may be
// written again.
void keep_level(const Study& study, StudyRun& run, const Progress& progress) {
  if (!study.options.processes.is_first()) return;
  const auto timings = run.timings;
  const auto warnings = run.built.warnings;
  write_results(study, run, progress);
  run.timings = timings;
  run.built.warnings = warnings;
}

// Of solids that cannot be made patches the report shows what is wrong. What an earlier run found stays: its
// own report can be made again.
StudyRun solved(const Study& study, int levels, const Progress& progress) {
  try {
    return levels > 1 ? run_levels(
                            study, levels, [&](StudyRun& run) { keep_level(study, run, progress); }, progress)
                      : run_study(study, progress);
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

ExitCode run_command(const StudyCommand& command, const Console& console, int levels) {
  const Study study = study_of(command);
  const auto folder = taken_folder(study);
  ProgressDisplay display(console);
  StudyRun run = solved(study, levels, display.progress());
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
  const auto options = std::make_shared<RunOptions>();
  CLI::App& run = add_spread_command(app, line, "run", "Solves a study and writes its results", run_examples,
                                     [options](const Console& console, const solvers::Processes& processes) {
                                       options->study.processes = processes;
                                       return run_command(options->study, console, options->levels);
                                     });
  add_study_options(run, options->study);
  run.add_option(
         "--levels", options->levels,
         "Solves at discretization.refine, one more, ...: N levels; the results are those of the finest, and "
         "until it is done of the one before")
      ->check(CLI::Range(1, 11))
      ->type_name("N");
}

}  // namespace isopatch::app
