#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/results/output_directory.hpp"
#include "app/study/study.hpp"
#include "solvers/processes.hpp"

namespace isopatch::app {

/// Options that `run` and `compare` share.
struct StudyCommand {
  std::filesystem::path study;
  std::vector<std::string> overrides;           ///< --set key=value
  std::optional<std::filesystem::path> output;  ///< --output; relative to the current folder
  solvers::Processes processes = {};  ///< that solve it together; all call the command, the first one writes
};

/// The study with all that the options say of it.
/// @throws Error as read_study does
Study study_of(const StudyCommand& command);

/// The study's output directory, taken before any long work; nothing on processes that do not write.
/// @throws Error io
std::unique_ptr<OutputFolder> taken_folder(const Study& study);

void add_study_options(CLI::App& command, StudyCommand& options);

}  // namespace isopatch::app
