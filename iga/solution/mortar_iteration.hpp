#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/discrete_solution.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// Solves with mortar multipliers, without a matrix; nodes of faces that match share their unknowns.
///
/// Both ways use the multigrid of Nitsche's method, whose energy is that of the constrained displacements but
/// for a bounded factor, however fine the elements are.
///
/// Method cg: conjugate gradients among the displacements that satisfy the constraints. The inner nodes of
/// slave faces follow from the others (`MortarProjection`, P): the operator is P^T K P, its preconditioner P
/// M P^T, and the multipliers are the forces that remain on these nodes.
///
/// Method minres: minimal residuals for [[K, B^T], [B, 0]] with a block diagonal preconditioner, M and for
/// the multipliers the inverse of their product in the metric of Nitsche's penalty. Takes two to four times
/// the iterations, but no node need follow others.
///
/// @throws Error unsupported  as MortarProjection does, with cg
/// @source  Benzi, Golub, Liesen, Numerical solution of saddle point problems, Acta Numerica 2005, sections 6
///          and 10
std::vector<DiscreteSolution> solve_with_mortar(const CoupledProblem& coupled,
                                                const solvers::SolverOptions& options,
                                                const Progress& progress);

}  // namespace isopatch::iga
