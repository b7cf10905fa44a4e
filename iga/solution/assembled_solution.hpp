#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/discrete_solution.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// Solves by assembling the linear system and giving it to `solvers::solve`.
/// @param options  method is not automatic
/// @return  one solution for each right side
/// @throws Error whatever assembly and `solvers::solve` throw
std::vector<DiscreteSolution> solve_assembled(const CoupledProblem& coupled,
                                              const solvers::SolverOptions& options,
                                              const Progress& progress);

}  // namespace isopatch::iga
