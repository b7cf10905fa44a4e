#pragma once

#include <string>

namespace isopatch::solvers {

/// Why MPI cannot find the other processes that the launcher started, and what to do; empty where it can try.
///
/// Open MPI takes part in a step of Slurm through PMIx alone, and without its variables ends the process.
std::string launcher_objection(int started);

/// Takes what launchers told this process out of its environment, so that MPI starts it as a process alone.
///
/// A launcher connects the processes that it started once. A shell in its step has the same variables for
/// every program that it runs, and only one of them can be the one that is waited for.
void leave_launcher();

}  // namespace isopatch::solvers
