#pragma once

#include "geometry/base/progress.hpp"
#include "iga/solution/nodal_solution.hpp"

namespace isopatch::iga {

/// Assembles the system and gives it to `solvers::solve`.
/// @throws Error whatever assembly and `solvers::solve` throw
NodalSolution solve_assembled(const SolutionTask& task, const solvers::SolverOptions& options,
                              const Progress& progress);

}  // namespace isopatch::iga
