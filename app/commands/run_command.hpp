#pragma once

#include "app/commands/study_command.hpp"

namespace isopatch::app {

/// Solves a study, writes its files, prints the summary.
/// @param levels  1, or more: the study as refined as it says, once more, ...
ExitCode run_command(const StudyCommand& command, const Console& console, int levels = 1);

void add_run_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
