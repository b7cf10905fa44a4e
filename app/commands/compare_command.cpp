#include "app/commands/compare_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/reports/compare_page.hpp"
#include "app/reports/comparison_report.hpp"

namespace isopatch::app {
namespace {

constexpr const char* compare_examples = R"(Examples:
  isopatch compare study.toml
  isopatch compare study.toml --set discretization.degree=3
  isopatch compare study.toml --levels 3             as refined as the study, once more, twice more
  isopatch compare study.toml --levels 3 --degrees 2,3
  isopatch compare study.toml --condition            with condition numbers of both systems
Prints tables and writes compare.html (for a browser) and compare.json, anew after each level. Exit code 1 if the couplings differ at any
level by more than 1e-9 in displacement or energy, or 1e-8 in multipliers, relatively.)";

/// What `isopatch compare` takes.
struct CompareOptions {
  StudyCommand study;
  LevelOptions levels;
};

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

ExitCode compare_command(const StudyCommand& command, const LevelOptions& options, const Console& console) {
  const Study study = study_of(command);
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

void add_compare_command(CLI::App& app, CommandLine& line) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& compare = add_spread_command(
      app, line, "compare", "Solves a study with both couplings and compares them", compare_examples,
      [options](const Console& console, const solvers::Processes& processes) {
        options->study.processes = processes;
        return compare_command(options->study, options->levels, console);
      });
  add_study_options(compare, options->study);
  LevelOptions& levels = options->levels;
  compare.add_option("--levels", levels.count, "Compares at discretization.refine, one more, ...: N levels")
      ->check(CLI::Range(1, 11))
      ->type_name("N");
  compare.add_option("--degrees", levels.degrees, "Compares all levels with each of these degrees: 2,3")
      ->delimiter(',')
      ->expected(1, 10)
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 10))
      ->type_name("P,P");
  compare.add_flag(
      "--condition", levels.condition,
      "Estimates the condition of systems that are factorized, which takes some thirty solutions more");
}

}  // namespace isopatch::app
