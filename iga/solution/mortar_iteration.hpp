#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/discrete_solution.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// Solves with mortar multipliers, without a matrix; nodes of faces that match share their unknowns.
///
/// Conjugate gradients (cg) or minimal residuals (minres) among the displacements that satisfy the
/// constraints: with the projection P onto these (`MortarProjection`) the operator is P^T K P and its
/// preconditioner P M P^T, M a multigrid in which springs tie the faces. The multipliers are the forces that
/// remain.
///
/// @throws Error singular_system  as MortarProjection does
/// @source  Benzi, Golub, Liesen, Numerical solution of saddle point problems, Acta Numerica 2005, sections 6
///          and 10.2 (constraint preconditioning)
std::vector<DiscreteSolution> solve_with_mortar(const CoupledProblem& coupled,
                                                const solvers::SolverOptions& options,
                                                const Progress& progress);

}  // namespace isopatch::iga
