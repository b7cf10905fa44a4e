#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/solve_report.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

/// Solves a system, with or without constraints, by UMFPACK's LU factorization with pivoting and iterative
/// refinement. Takes about twice the memory of a symmetric factorization; does not see whether K is
/// indefinite.
///
/// @throws Error singular_system  with the estimate of the reciprocal condition
/// @throws Error out_of_memory    with the bytes that were asked for
/// @source Davis 2004 (UMFPACK)
std::vector<LinearSolution> solve_with_umfpack(const ScaledSystems& systems, const SolverOptions& options,
                                               const Progress& progress);

}  // namespace isopatch::solvers
