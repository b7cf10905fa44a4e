#pragma once

#include <string>
#include <vector>

#include "app/console.hpp"

namespace isopatch::app {

/// What the program tells the shell.
enum class ExitCode {
  ok = 0,
  failed = 1,        ///< the run failed: supports, solver, memory, couplings that disagree
  wrong_input = 2,   ///< a study, a model or a command line that cannot be right
  file_problem = 3,  ///< a file that cannot be read or written
  interrupted = 130,
};

/// The isopatch program: one command with its options.
/// @param arguments  without the program's name
/// @return  the exit code; every error has been written to console.err
int run_program(const std::vector<std::string>& arguments, const Console& console);

}  // namespace isopatch::app
