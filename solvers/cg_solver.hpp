#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/solve_report.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

/// Solves a system without constraints by conjugate gradients with the inverted diagonal blocks as
/// preconditioner. Starts again from the true residual where the updated one has drifted from it.
///
/// A singular matrix is seen only where the load excites its kernel.
///
/// @throws Error singular_system  a direction without positive energy, or a diagonal block without
/// @throws Error not_converged    with the residual reached and advice
/// @cost   12 vectors beside the matrix; iterations grow like the square root of the condition
std::vector<LinearSolution> solve_with_cg(const ScaledSystems& systems, const SolverOptions& options,
                                          const Progress& progress);

}  // namespace isopatch::solvers
