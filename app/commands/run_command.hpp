#pragma once

#include "app/commands/study_command.hpp"

namespace isopatch::app {

/// Solves a study, writes its files, prints the summary.
ExitCode run_command(const StudyCommand& command, const Console& console);

void add_run_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
