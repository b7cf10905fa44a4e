#pragma once

#include "solvers/processes.hpp"

namespace isopatch::solvers {

/// Cores of this computer that this process may use, at least one: those that its launcher, `taskset` or a
/// batch system gave it, where one did. OMP_PROC_BIND takes none of them away.
int usable_cores();

/// The processes and threads of a run on one computer, and the cores that they may use there together.
struct Crowd {
  int processes = 1;
  int threads = 1;  ///< of all of them
  int cores = 1;    ///< that at least one of them may use
  bool is_too_large() const { return threads > cores; }
};
/// The crowd on the computer with the most threads per core. All processes must call it.
/// @param threads  of this process
Crowd largest_crowd(const Processes& processes, int threads);

}  // namespace isopatch::solvers
