#include "app/commands/run_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/commands/write_results.hpp"
#include "app/problem/solid_stages.hpp"
#include "app/reports/cutting_page.hpp"
#include "app/reports/stage_scene.hpp"
#include "app/results/summary_text.hpp"
#include "app/run/run_accuracy.hpp"
#include "app/run/run_levels.hpp"
#include "app/solids/fault_page.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/solid_error.hpp"
#include "segmentation/decomposition/cutting_error.hpp"

namespace isopatch::app {
namespace {

constexpr const char* run_examples = R"(Examples:
  isopatch run study.toml
  isopatch run study.toml --output /tmp/fine --set discretization.refine=2
  isopatch run study.toml --set load.0.traction='["20 MPa", 0, 0]' --set coupling.method=lagrange
  isopatch run study.toml --levels 3                 how energy, stresses and errors converge
  isopatch run study.toml --set accuracy.energy='1 %'  refines where it is needed until the estimated error is so small
  isopatch run study.toml --to hexahedra             of solids or triangles: how they are cut, not more
  isopatch run study.toml --from patches             fits and solves again, with the solid and hexahedra as they are kept
  mpiexec -n 4 isopatch run study.toml               the same figures from four processes
  srun --mpi=pmix -n 4 -c 8 isopatch run study.toml  with Slurm, 8 threads each
  isopatch run study.toml --quiet && jq .results.internal_energy results/summary.json
Writes report.html (open it in a browser), summary.json, results.vtm and others with fields/ (ParaView) and
results.h5 (isopatch report, probe, fields, info).
Files appear whole or not at all, and only after everything has been computed, with --levels and [accuracy] level by level; but for the folder stages, which keeps the
solid, its hexahedra and its patches as soon as they are made: a further run takes what nothing has changed, so that another
load is solved alone.)";

/// The solids of a study, or nothing of one whose model has patches already.
const BlocksInput* solids_of(const Study& study) {
  return std::get_if<BlocksInput>(&study.model.source);
}

/// The scenes of what was finished before a body could not be cut.
std::vector<BlockStage> stages_before(const BlocksInput& solids) {
  const auto kept = StageFolder(solids.stages).last(Stage::solid);
  std::optional<BlockScene> scene = kept ? stage_scene({*kept}) : std::nullopt;
  return scene ? std::move(scene->stages) : std::vector<BlockStage>{};
}

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
[[noreturn]] void shown(const Study& study, const BlocksInput& solids, const geometry::SolidError& error) {
  const std::filesystem::path& directory = study.output.directory;
  const auto* cutting = dynamic_cast<const segmentation::CuttingError*>(&error);
  write_in(directory, "report.html",
           cutting && !cutting->parts().empty()
               ? cutting_fault_html(*cutting, study.title, study.text, stages_before(solids))
               : fault_html(solids, error, study.title, study.text));
  throw Error(error.code(), shown_in(error, directory / "report.html"));
}

[[noreturn]] void shown(const Study& study, const BlocksInput& solids, const ReconstructionError& error) {
  const std::filesystem::path& directory = study.output.directory;
  const auto page = triangles_fault_html(solids, error, study.title, study.text);
  if (!page) throw error;
  write_in(directory, "report.html", *page);
  throw Error(error.code(),
              fmt::format("{}; {} shows it", error.what(), (directory / "report.html").string()));
}

/// What a function gives; where it fails, the report shows what is wrong with solids.
template <class Make>
auto with_faults_shown(const Study& study, const Make& make) {
  const BlocksInput* solids = solids_of(study);
  const bool shows = study.options.processes.is_first() && study.output.report && solids;
  try {
    return make();
  } catch (const geometry::SolidError& error) {
    if (!shows) throw;
    shown(study, *solids, error);
  } catch (const ReconstructionError& error) {
    if (!shows) throw;
    shown(study, *solids, error);
  }
}

/// The study with what the command says about stages.
/// @throws Error invalid_argument  a model without stages
Study study_from(const RunCommand& command) {
  Study study = study_of(command.study);
  if (command.from.empty() && command.to.empty()) return study;
  auto* solids = std::get_if<BlocksInput>(&study.model.source);
  if (!solids)
    throw Error(ErrorCode::invalid_argument,
                "--from and --to are for models of solids or triangles; this one has patches already");
  if (solids->stages.folder.empty())
    throw Error(ErrorCode::invalid_argument,
                "--from and --to need stages that are kept, but the study has output.stages = false");
  if (!command.from.empty()) solids->stages.from = *find_choice(stage_choices(), command.from);
  return study;
}

/// Removes the page of stages alone: the report shows them.
void remove_stage_page(const Study& study) {
  const BlocksInput* solids = solids_of(study);
  std::error_code ignored;
  if (solids && study.output.report && !solids->stages.folder.empty())
    std::filesystem::remove(solids->stages.folder / "report.html", ignored);
}

/// Makes what comes before the solution, and a page of it.
ExitCode run_stages(const Study& study, Stage to, const Console& console) {
  const BlocksInput& solids = *solids_of(study);
  ProgressDisplay display(console);
  const StagedPatches found =
      with_faults_shown(study, [&] { return staged_patches(solids, to, display.progress()); });
  if (!study.options.processes.is_first()) return ExitCode::ok;
  const std::filesystem::path page = solids.stages.folder / "report.html";
  display.progress()("writing the page", 0);
  if (study.output.report) write_file(page, stages_html(found.stages, study.title, study.text));
  display.clear();
  for (const StageReport& stage : found.stages)
    if (!stage.problem.empty()) console.warn(stage.problem);
  if (found.made)
    for (const std::string& warning : found.made->report.warnings) console.warn(warning);
  if (console.quiet) return ExitCode::ok;
  console.out << fmt::format("  stages            {}\n", stages_text(found.stages));
  if (study.output.report) console.out << fmt::format("  {} shows them\n", page.string());
  return ExitCode::ok;
}

}  // namespace

ExitCode run_command(const RunCommand& command, const Console& console) {
  const Study study = study_from(command);
  if (command.levels > 1 && study.accuracy.is_asked())
    throw error_at(
        study.accuracy.place,
        "[accuracy] refines as far as it is needed and --levels as often as it says: leave one away");
  const auto folder = taken_folder(study);
  if (!command.to.empty() && command.to != name_of(stage_choices(), Stage::solution))
    return run_stages(study, *find_choice(stage_choices(), command.to), console);
  ProgressDisplay display(console);
  StudyRun run = with_faults_shown(study, [&] {
    const Progress progress = display.progress();
    const auto keep = [&](StudyRun& level) { keep_level(study, level, progress); };
    if (study.accuracy.is_asked()) return run_accuracy(study, keep, progress);
    if (command.levels == 1) return run_study(study, progress);
    return run_levels(study, command.levels, keep, progress);
  });
  if (!study.options.processes.is_first()) return ExitCode::ok;
  const std::vector<std::string> files = write_results(study, run, display.progress());
  remove_stage_page(study);
  display.clear();
  for (const Warning& warning : run.built.warnings) console.warn(warning.text);
  if (!console.quiet)
    console.out << summary_text(study, run)
                << fmt::format("  results in        {}: {}\n", study.output.directory.string(),
                               fmt::join(files, ", "));
  return ExitCode::ok;
}

void add_run_command(CLI::App& app, CommandLine& line) {
  const auto options = std::make_shared<RunCommand>();
  CLI::App& run = add_spread_command(app, line, "run", "Solves a study and writes its results", run_examples,
                                     [options](const Console& console, const solvers::Processes& processes) {
                                       options->study.processes = processes;
                                       return run_command(*options, console);
                                     });
  add_study_options(run, options->study);
  run.add_option(
         "--levels", options->levels,
         "Solves at discretization.refine, one more, ...: N levels; the results are those of the finest, and "
         "until it is done of the one before")
      ->check(CLI::Range(1, 11))
      ->type_name("N");
  run.add_option(
         "--from", options->from,
         "The first stage that is made anew whatever is kept of an earlier run; otherwise the first that "
         "files, keys or the program have changed")
      ->check(CLI::IsMember(names(stage_choices())))
      ->type_name("STAGE");
  run.add_option(
         "--to", options->to,
         "The last stage: solid, hexahedra, patches or solution; kept in the folder stages of the results")
      ->check(CLI::IsMember(names(stage_choices())))
      ->type_name("STAGE");
}

}  // namespace isopatch::app
