#pragma once

#include <vector>

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

/// The same for several right sides, f or f and g, in place of the system's own: set up once, solved together
/// where the method can. Loads that are zero cost nothing.
/// @return  one solution for each load, the one that `solve` gives but for round-off; the reports share what
///          the set-up took, and each has its part of the time to solve
/// @cost    one factorization or set-up; a direct method goes through its factors once a step for all loads
std::vector<LinearSolution> solve_each(const LinearSystem& system, const std::vector<Eigen::VectorXd>& loads,
                                       const SolverOptions& options = {}, const Progress& progress = {});

}  // namespace isopatch::solvers
