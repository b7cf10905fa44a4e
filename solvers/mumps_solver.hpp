#pragma once

#include <cstdint>
#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/solve_report.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

/// Solves a system, with or without constraints, by MUMPS' LDL^T factorization with pivoting and iterative
/// refinement.
///
/// The factors' inertia proves what LinearSystem promises: as many negative pivots as constraints and none
/// that is zero, else K is not positive definite on the kernel of B or B has not full rank.
///
/// @throws Error singular_system  with the number of zero and negative pivots
/// @throws Error out_of_memory    with the megabytes that MUMPS asked for
/// @throws Error unsupported      for more than 2^31 - 2 unknowns and multipliers
/// @cost   spread over processes, each keeps its own entries and its share of the factor; ordering, right
/// side
///         and solution are the first one's
/// @source Amestoy, Duff, L'Excellent, Koster 2001 (MUMPS); inertia: Gould 1985
std::vector<LinearSolution> solve_with_mumps(const ScaledSystems& systems, const SolverOptions& options,
                                             const Progress& progress);

/// How many eigenvalues of a symmetric matrix are negative, by the pivots of its factors (Sylvester's law).
/// @throws Error singular_system  a pivot that is zero to working precision
/// @cost   one factorization
std::int64_t negative_eigenvalues(const SymmetricBlockMatrix& matrix);

}  // namespace isopatch::solvers
