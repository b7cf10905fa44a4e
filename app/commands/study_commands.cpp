#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "app/base/exit_code.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/write_results.hpp"
#include "app/reports/compare_page.hpp"
#include "app/reports/comparison_report.hpp"
#include "app/results/output_directory.hpp"
#include "app/results/summary.hpp"
#include "app/run/compare_levels.hpp"
#include "app/solids/fault_page.hpp"
#include "app/study/study_keys.hpp"

namespace isopatch::app {
namespace {

Study read(const StudyCommand& command) {
  Study study = read_study(command.study, command.overrides);
  if (command.output) study.output.directory = *command.output;
  study.options.processes = command.processes;
  return study;
}

// For the process that writes, and before any long work.
std::unique_ptr<OutputFolder> taken_folder(const Study& study) {
  return study.options.processes.is_first() ? std::make_unique<OutputFolder>(study.output.directory)
                                            : nullptr;
}

// Of solids that cannot be made patches the report shows what is wrong. What an earlier run found stays: its
// own report can be made again.
StudyRun solved(const Study& study, const Progress& progress) {
  try {
    return run_study(study, progress);
  } catch (const geometry::SolidError& error) {
    if (!study.options.processes.is_first() || !study.output.report || !study.model.blocks) throw;
    const std::filesystem::path& directory = study.output.directory;
    write_in(directory, "report.html", fault_html(*study.model.blocks, error, study.title, study.text));
    throw Error(error.code(), shown_in(error, directory / "report.html"));
  }
}

// Anew after each level, so that nothing finished is lost.
void write_comparison(const Study& study, const ComparedStudy& level,
                      const std::vector<CouplingComparison>& all) {
  const std::filesystem::path& directory = study.output.directory;
  if (all.size() == 1) remove_earlier_comparison(directory);
  const std::string json = comparison_json(study, all);
  if (study.output.report) write_in(directory, "compare.html", compare_html(study, level, all, json));
  write_in(directory, "compare.json", json);
}

}  // namespace

ExitCode run_command(const StudyCommand& command, const Console& console) {
  const Study study = read(command);
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

ExitCode compare_command(const StudyCommand& command, const LevelOptions& options, const Console& console) {
  const Study study = read(command);
  const auto folder = taken_folder(study);
  const bool writes = command.processes.is_first();
  ProgressDisplay display(console);
  const LevelReport report = compare_levels(
      study, options,
      [&](const ComparedStudy& level, const std::vector<CouplingComparison>& all) {
        if (writes) write_comparison(study, level, all);
      },
      display.progress());
  display.clear();
  const auto disagreeing = std::find_if(report.levels.begin(), report.levels.end(),
                                        [](const CouplingComparison& level) { return !level.agree(); });
  const bool done = disagreeing == report.levels.end() && report.stopped.empty();
  if (!writes) return done ? ExitCode::ok : ExitCode::failed;
  for (const Warning& warning : report.levels.back().warnings) console.warn(warning.text);
  if (!console.quiet) {
    console.out << comparison_text(study, report.levels.back());
    if (report.levels.size() > 1) console.out << levels_text(report.levels);
    console.out << fmt::format("  results in        {}: {}compare.json\n", study.output.directory.string(),
                               study.output.report ? "compare.html, " : "");
  }
  if (disagreeing != report.levels.end()) console.fail(disagreement_text(*disagreeing));
  if (!report.stopped.empty()) console.fail(report.stopped);
  return done ? ExitCode::ok : ExitCode::failed;
}

ExitCode keys_command(const std::string& topic, const Console& console) {
  console.out << study_documentation(topic);
  return ExitCode::ok;
}

}  // namespace isopatch::app
