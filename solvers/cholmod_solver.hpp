#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "solvers/block_lanczos.hpp"
#include "solvers/linear_operator.hpp"
#include "solvers/linear_system.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/solve_report.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::solvers {

/// Solves a system without constraints by CHOLMOD's supernodal Cholesky factorization and iterative
/// refinement.
///
/// @throws Error singular_system  naming the block row where a pivot is zero, negative, or so small beside
/// the
///                                diagonal that only round-off keeps it positive
/// @throws Error out_of_memory    with the bytes that the factor needs
/// @cost   the factorization's flops are in the report; memory about 8 bytes per factor entry and 108 bytes
/// per
///         block of the matrix
/// @source Chen, Davis, Hager, Rajamanickam 2008 (CHOLMOD)
std::vector<LinearSolution> solve_with_cholmod(const ScaledSystems& systems, const SolverOptions& options,
                                               const Progress& progress);

/// A factorization to be used many times, without refinement: the coarsest level of a multigrid. Any positive
/// pivot will do, since who iterates judges the result by the true residual.
/// @throws Error singular_system, out_of_memory  for pivots that are not positive, and as solve_with_cholmod
VectorsOperator cholmod_inverse(SymmetricBlockMatrix matrix);

/// The same for several right sides at once, and with the pivots checked as `solve_with_cholmod` does.
BlockOperator cholmod_block_inverse(SymmetricBlockMatrix matrix);

}  // namespace isopatch::solvers
