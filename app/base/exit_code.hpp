#pragma once

#include "geometry/base/error.hpp"

namespace isopatch::app {

/// What the program tells the shell.
enum class ExitCode {
  ok = 0,
  failed = 1,        ///< the run failed: supports, solver, memory, couplings that disagree
  wrong_input = 2,   ///< a study, a model or a command line that cannot be right
  file_problem = 3,  ///< a file that cannot be read or written
  interrupted = 130,
};

/// What the program tells the shell of an error.
ExitCode exit_code(ErrorCode code);

}  // namespace isopatch::app
