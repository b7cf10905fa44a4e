#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/discrete_solution.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// Solves with patches coupled by multipliers: minimal residuals for the saddle point, whose operator keeps
/// every patch and every multiplier by itself, without a matrix.
///
/// K is singular on floating patches; K + g Q is not and has the same solution, Q the projection onto
/// jumps across interfaces and g a stiffness per global node. The preconditioner is block diagonal: the
/// multigrid on what is continuous, 1 / g on jumps, g (B B^T)^-1 on multipliers. Nothing is factorized but
/// the multigrid's coarsest level.
///
/// @source  Benzi, Golub, Liesen, Numerical solution of saddle point problems, Acta Numerica 2005, sections
/// 8, 10
std::vector<DiscreteSolution> solve_with_multipliers(const CoupledProblem& coupled,
                                                     const solvers::SolverOptions& options,
                                                     const Progress& progress);

}  // namespace isopatch::iga
