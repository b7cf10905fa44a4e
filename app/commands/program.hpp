#pragma once

#include <string>
#include <vector>

#include "app/base/exit_code.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

/// The isopatch program: one command with its options.
/// @param arguments  without the program's name
/// @return  the exit code; every error has been written to console.err
int run_program(const std::vector<std::string>& arguments, const Console& console);

}  // namespace isopatch::app
