#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/discrete_solution.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// Solves with multipliers on faces that do not match, without a matrix: minimal residuals for
/// [[K, B^T], [B, 0]], the patches' matching faces eliminated.
///
/// K is singular on bodies that multipliers alone hold, but positive definite where B x = 0. The
/// preconditioner is block diagonal: the multigrid of Nitsche's method for the displacements, and for the
/// multipliers the inverse of their product in the metric that Nitsche's penalty gives, which is near B
/// K_N^-1 B^T. So the number of iterations follows from the stability of the multipliers and the quality of
/// the multigrid.
///
/// @source  Benzi, Golub, Liesen, Numerical solution of saddle point problems, Acta Numerica 2005, section 10
std::vector<DiscreteSolution> solve_with_mortar(const CoupledProblem& coupled,
                                                const solvers::SolverOptions& options,
                                                const Progress& progress);

}  // namespace isopatch::iga
