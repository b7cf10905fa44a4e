#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands.hpp"
#include "app/compare_couplings.hpp"
#include "app/output_directory.hpp"
#include "app/study_keys.hpp"
#include "app/summary.hpp"
#include "app/write_results.hpp"

namespace isopatch::app {
namespace {

Study read(const StudyCommand& command) {
  Study study = read_study(command.study, command.overrides);
  if (command.output) study.output.directory = *command.output;
  study.options.processes = command.processes;
  if (command.processes.is_first()) check_writable(study.output.directory);
  return study;
}

}  // namespace

ExitCode run_command(const StudyCommand& command, const Console& console) {
  const Study study = read(command);
  ProgressDisplay display(console);
  StudyRun run = run_study(study, display.progress());
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

ExitCode compare_command(const StudyCommand& command, const Console& console) {
  const Study study = read(command);
  ProgressDisplay display(console);
  const CouplingComparison comparison = compare_couplings(study, display.progress());
  if (!command.processes.is_first()) return comparison.agree() ? ExitCode::ok : ExitCode::failed;
  write_in(study.output.directory, "compare.json", comparison_json(study, comparison));
  display.clear();
  for (const Warning& warning : comparison.warnings) console.warn(warning.text);
  if (!console.quiet)
    console.out << comparison_text(study, comparison)
                << fmt::format("  written to {}\n", (study.output.directory / "compare.json").string());
  if (comparison.agree()) return ExitCode::ok;
  console.fail(fmt::format(
      "the two couplings disagree: relative difference {:.2g} in displacement, {:.2g} in energy (allowed "
      "{:.0e}), {:.2g} in multipliers (allowed {:.0e}); look at the solver's residuals and at the model's "
      "gaps",
      comparison.displacement_difference, comparison.energy_difference,
      CouplingComparison::allowed_difference, comparison.multiplier_difference,
      CouplingComparison::allowed_multiplier_difference));
  return ExitCode::failed;
}

ExitCode keys_command(const std::string& topic, const Console& console) {
  console.out << study_documentation(topic);
  return ExitCode::ok;
}

}  // namespace isopatch::app
