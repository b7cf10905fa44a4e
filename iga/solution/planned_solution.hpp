#pragma once

#include <vector>

#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/discrete_solution.hpp"
#include "iga/solution/solver_choice.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// The solutions and how they came about.
struct PlannedSolution {
  std::vector<DiscreteSolution> solutions;  ///< one per right side
  double predicted_bytes = 0;               ///< the most of all plans that were tried
  bool is_first = true;                     ///< whether the first plan gave it
};

/// Solves a problem by the first of some plans, and by the next ones where that fails: factors that are
/// singular to working precision or do not reach the tolerance leave iterations, and the other way round.
/// `reason` of the report says what was tried and why it failed.
///
/// A singular matrix is taken for one if there are too few Gauss points to give every motion an energy; else
/// it can be so to working precision only, for `require_supported` has found no motion without energy.
///
/// @param plans  at least one
/// @throws Error  that of the last plan, with those before it and what in the problem is the likely cause
PlannedSolution solve_as_planned(const CoupledProblem& coupled, const std::vector<SolverPlan>& plans,
                                 const solvers::SolverOptions& options, const Progress& progress);

}  // namespace isopatch::iga
