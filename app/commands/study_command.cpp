#include "app/commands/study_command.hpp"

#include <CLI/CLI.hpp>
#include <variant>

#include "app/study/parse_study.hpp"

namespace isopatch::app {

Study study_of(const StudyCommand& command) {
  Study study = read_study(command.study, command.overrides);
  if (command.output) study.output.directory = *command.output;
  study.options.processes = command.processes;
  if (auto* solids = std::get_if<BlocksInput>(&study.model.source); solids && study.output.stages)
    solids->stages = {.folder = study.output.directory / stage_folder_name,
                      .writes = command.processes.is_first()};
  return study;
}

std::unique_ptr<OutputFolder> taken_folder(const Study& study) {
  return study.options.processes.is_first() ? std::make_unique<OutputFolder>(study.output.directory)
                                            : nullptr;
}

void add_study_options(CLI::App& command, StudyCommand& options) {
  command.add_option("study", options.study, "The study file (TOML)")->required();
  command.add_option("--set", options.overrides, "Replaces a key: --set discretization.refine=2")
      ->take_all()
      ->expected(1)
      ->type_name("KEY=VALUE");
  command.add_option("-o,--output", options.output, "Directory of the results")->type_name("DIR");
}

}  // namespace isopatch::app
