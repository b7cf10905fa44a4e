#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/discrete_solution.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// Solves with patches coupled by elimination: conjugate gradients with the multigrid.
/// @param options  form says whether a matrix is stored: not automatic
/// @return  one solution for each right side
/// @throws Error whatever `solvers::solve_with_cg`, assembly and multigrid throw
/// @cost   matrix-free about 40 vectors of unknowns, assembled the matrix as well
std::vector<DiscreteSolution> solve_eliminated(const CoupledProblem& coupled,
                                               const solvers::SolverOptions& options,
                                               const Progress& progress);

}  // namespace isopatch::iga
