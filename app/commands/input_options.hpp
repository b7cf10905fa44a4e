#pragma once

#include <string>

#include "app/commands/command_line.hpp"
#include "app/results/load_input.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class Validator;
}

namespace isopatch::app {

/// A check of options that take a number above 0. (CLI11's own names its upper bound, all 309 digits of it.)
CLI::Validator above_zero();

/// The options of commands that read CAD files.
void add_reading(CLI::App& command, CadReading& reading);

/// The option of commands that work on stored results: which load case.
void add_case(CLI::App& command, std::string& name);

/// The options of commands that take any kind of file.
void add_input(CLI::App& command, InputFile& input);

}  // namespace isopatch::app
