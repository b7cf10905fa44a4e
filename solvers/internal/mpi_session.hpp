#pragma once

#include <mpi.h>

namespace isopatch::solvers {

/// Starts MPI if nobody has, until the end of the program.
/// @throws Error internal
void start_mpi();

}  // namespace isopatch::solvers
