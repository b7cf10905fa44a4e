#pragma once

#include "iga/solution/nodal_solution.hpp"

namespace isopatch::iga {

/// Patches coupled by elimination: conjugate gradients with the multigrid.
/// @throws Error whatever `solvers::solve_with_cg`, assembly and multigrid throw
/// @cost   matrix-free about 40 vectors of unknowns, assembled the matrix as well
NodalSolution solve_eliminated(const SolutionTask& task, const solvers::SolverOptions& options,
                               solvers::Operator form, const Progress& progress);

}  // namespace isopatch::iga
