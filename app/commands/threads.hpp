#pragma once

#include "app/commands/console.hpp"
#include "solvers/processes.hpp"

namespace isopatch::app {

/// As many threads as were asked for, else as the environment says, else an even share of the cores that this
/// and the other processes on the computer may use. Warns where they outnumber the cores. All processes must
/// call it.
/// @param asked  0 for none in particular
void set_threads(int asked, const solvers::Processes& processes, const Console& console);

}  // namespace isopatch::app
