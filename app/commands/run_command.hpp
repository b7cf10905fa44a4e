#pragma once

#include <string>

#include "app/commands/study_command.hpp"

namespace isopatch::app {

/// What of a study is done, and how often.
struct RunCommand {
  StudyCommand study;
  int levels = 1;         ///< or more: the study as refined as it says, once more, ...
  std::string from = {};  ///< the first stage that is made anew whatever is kept; "": the first that changed
  std::string to = {};    ///< the last stage; "": the solution
};

/// Solves a study, writes its files, prints the summary; or makes it ready up to a stage.
ExitCode run_command(const RunCommand& command, const Console& console);

void add_run_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
