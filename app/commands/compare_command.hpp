#pragma once

#include "app/commands/study_command.hpp"
#include "app/run/compare_levels.hpp"

namespace isopatch::app {

/// Solves each level with both couplings, writes compare.json after each, prints the tables; `failed` if they
/// disagree at any level or memory ends the work.
ExitCode compare_command(const StudyCommand& command, const LevelOptions& levels, const Console& console);

void add_compare_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
