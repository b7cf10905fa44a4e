#pragma once

#include "geometry/base/progress.hpp"
#include "solvers/linear_system.hpp"
#include "solvers/solve_report.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

/// Solves a linear system by the method that the options name.
///
/// @throws Error invalid_argument  options out of range, no method named or one that cannot treat the system,
/// a
///                                 multigrid or no matrix asked for
/// @throws Error singular_system   a zero or negative pivot, saying at which block row
/// @throws Error not_converged     with the residual reached and advice
/// @throws Error out_of_memory     with the memory that was asked for where the library says it
LinearSolution solve(const LinearSystem& system, const SolverOptions& options = {},
                     const Progress& progress = {});

}  // namespace isopatch::solvers
