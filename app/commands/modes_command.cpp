#include "app/commands/modes_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <variant>

#include "app/base/engineering_units.hpp"
#include "app/problem/build_problem.hpp"
#include "app/results/modes_json.hpp"
#include "app/results/output_directory.hpp"
#include "app/results/summary_text.hpp"
#include "app/results/unfinished_results.hpp"
#include "app/results/write_fields.hpp"
#include "app/study/parse_study.hpp"
#include "geometry/base/error.hpp"
#include "iga/post/results.hpp"
#include "iga/solution/natural_modes.hpp"

namespace isopatch::app {
namespace {

constexpr const char* modes_examples = R"(Examples:
  isopatch modes study.toml
  isopatch modes study.toml --set modes.number=20 --output modes
  isopatch modes study.toml --set modes.free=true    without its supports: the six rigid motions are named as such
The study is that of a run; materials need densities, loads count for nothing, and a free body moves freely. [modes] has the options. Writes
modes.json and, unless output.fields is false, modes/N/results.vtm with the shape of mode N. On one process.
Of [solver] memory_limit holds, the rest counts for nothing; patches are coupled by elimination, those that do not match
by Nitsche's method, unless coupling.non_matching refuses them.)";

std::string modes_text(const iga::NaturalModes& found) {
  std::string text;
  int number = 0;
  for (const iga::NaturalMode& mode : found.modes)
    text += mode.is_rigid
                ? fmt::format("  rigid motion      {}, residual {:.1e}\n", with_unit(0, "Hz"), mode.residual)
                : fmt::format("  mode {:<12} {}, residual {:.1e}\n", ++number,
                              with_unit(mode.frequency, "Hz"), mode.residual);
  text += fmt::format("  orthogonal        to {:.1e} in the mass\n", found.worst_orthogonality);
  if (found.counted > 0)
    text += fmt::format("  counted           {} modes up to {}, rigid motions among them\n", found.counted,
                        with_unit(found.counted_to, "Hz"));
  return text;
}

// Whatever the study says of runs.
std::string coupled_text(const BuiltProblem& built) {
  if (built.report.non_matching.empty()) return "";
  return non_matching_text(built.report) + "  coupled           by elimination and Nitsche's method\n";
}

// The shape with a largest displacement of a tenth of the part.
iga::ElasticField field_of(const BuiltProblem& built, const iga::NaturalMode& mode) {
  const iga::ElasticityProblem& problem = built.problem;
  iga::ElasticField field{problem.discretization.patches, mode.shape, problem.materials};
  const double largest = iga::max_displacement(field).value;
  const double factor = largest > 0 ? 0.1 * built.report.box.diagonal().norm() / largest : 1;
  for (Eigen::Matrix3Xd& of_patch : field.displacement) of_patch *= factor;
  return field;
}

void write_shapes(const Study& study, const BuiltProblem& built, const iga::NaturalModes& found,
                  const std::filesystem::path& folder, const Progress& progress) {
  int number = 0;
  for (const iga::NaturalMode& mode : found.modes)
    if (!mode.is_rigid)
      write_fields(field_of(built, mode), built.problem.discretization.model, {}, study.output.field_options,
                   folder / modes_folder / fmt::format("{}", ++number), progress);
}

// The figures first, and only when all is there in the place of an earlier run's files.
void write_modes(const Study& study, const BuiltProblem& built, const iga::NaturalModes& found,
                 const Progress& progress) {
  UnfinishedResults unfinished(modes_results, study.output.directory);
  try {
    write_in(unfinished.folder(), "modes.json",
             modes_json(study, found, !built.report.non_matching.empty(), built.warnings));
    if (study.output.fields) write_shapes(study, built, found, unfinished.folder(), progress);
    unfinished.replace_earlier();
  } catch (const Error& error) {
    if (!unfinished.keep_essence()) throw;
    throw Error(error.code(), fmt::format("{}. The frequencies are kept in {}", error.what(),
                                          (unfinished.folder() / "modes.json").string()));
  }
}

// Of the ways to solve, modes have one: interfaces eliminated or by Nitsche's method, by factors. The limit
// on memory is theirs too.
void leave_only_memory_limit(iga::ElasticityOptions& options) {
  options.coupling = iga::Coupling::elimination;
  options.non_matching = iga::NonMatchingCoupling::nitsche;
  const double limit = options.solver.memory_limit;
  options.solver = {};
  options.solver.memory_limit = limit;
}

// What does not fit for the most sparing way to solve does not for factors either, which modes need.
BuiltProblem built_for_modes(const Study& study, const Progress& progress) {
  try {
    return build_problem(study, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::out_of_memory) throw;
    throw Error(error.code(),
                fmt::format("natural modes need factors, for which there is no memory: not even "
                            "iterations would fit: {}",
                            error.what()));
  }
}

}  // namespace

ExitCode modes_command(const ModesCommand& command, const Console& console,
                       const solvers::Processes& processes) {
  if (processes.count() > 1)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("modes are found on one process, and there are {}: start it without a launcher",
                            processes.count()));
  Study study = read_study(command.study, command.overrides);
  if (command.output) study.output.directory = *command.output;
  leave_only_memory_limit(study.options);
  const OutputFolder folder(study.output.directory);
  ProgressDisplay display(console);
  const Progress progress = display.progress();
  BuiltProblem built = built_for_modes(study, progress);
  // A free body's points are for loads: it moves freely here.
  std::erase_if(built.problem.supports, [&](const iga::Support& support) {
    return study.modes.is_free || std::holds_alternative<iga::FreeBodySupport>(support.condition);
  });
  const iga::NaturalModes found = iga::natural_modes(built.problem,
                                                     {.number = study.modes.number,
                                                      .quadrature_points = study.options.quadrature_points,
                                                      .count = study.modes.count,
                                                      .memory_limit = study.options.solver.memory_limit},
                                                     progress);
  write_modes(study, built, found, progress);
  display.clear();
  for (const Warning& warning : built.warnings) console.warn(warning.text);
  if (!console.quiet)
    console.out << (study.title.empty() ? "" : study.title + "\n") << coupled_text(built) << modes_text(found)
                << fmt::format("  results in        {}: modes.json{}\n", study.output.directory.string(),
                               study.output.fields ? ", modes/1/results.vtm, ..." : "");
  return ExitCode::ok;
}

void add_modes_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<ModesCommand>();
  CLI::App& modes = add_spread_command(
      app, line, "modes", "Natural frequencies and shapes of a study's part", modes_examples,
      [command](const Console& console, const solvers::Processes& processes) {
        return modes_command(*command, console, processes);
      });
  modes.add_option("study", command->study, "The study file (TOML)")->required();
  modes.add_option("--set", command->overrides, "Replaces a key: --set modes.number=20")
      ->take_all()
      ->expected(1)
      ->type_name("KEY=VALUE");
  modes.add_option("-o,--output", command->output, "Directory of the results")->type_name("DIR");
}

}  // namespace isopatch::app
