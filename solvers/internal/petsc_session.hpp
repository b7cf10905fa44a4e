#pragma once

namespace isopatch::solvers {

/// Starts PETSc, and MPI with it, at the first call in the process; later calls do nothing.
///
/// Signal handlers stay the program's own. What was started here is finished when the process exits, what
/// somebody else started is left alone. PETSC_OPTIONS in the environment is honoured.
///
/// @throws Error internal
/// @cost   0.1 s or so once; nothing in isopatch that works without PETSc calls it
void start_petsc();

}  // namespace isopatch::solvers
