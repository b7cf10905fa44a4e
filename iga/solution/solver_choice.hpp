#pragma once

#include <string>
#include <vector>

#include "iga/solution/size_forecast.hpp"
#include "solvers/solve.hpp"

namespace isopatch::iga {

/// How a problem is going to be solved, with nothing left open, and the memory that takes.
struct SolverPlan {
  solvers::Method method = solvers::Method::cholmod;                            ///< never automatic
  solvers::Preconditioner preconditioner = solvers::Preconditioner::multigrid;  ///< of cg and minres
  solvers::Operator form = solvers::Operator::assembled;                        ///< never automatic
  double predicted_bytes = 0;  ///< of the process with most, at its peak, beyond what it holds before
  std::string reason;          ///< one sentence
};

bool is_iterative(const SolverPlan& plan);

/// Bytes that assembly and solver may take: the limit of the options less what the process holds now, or what
/// the machine has to spare, shared among the processes on a computer. The same on all processes.
double available_bytes(const solvers::SolverOptions& options, const solvers::Processes& processes);

/// Chooses what the options leave open: the first plan is to be followed, the others if those before it fail.
/// A method asked for by name has one plan.
///
/// `auto` factorizes where the forecast of the factor costs less than iterations would for all load cases
/// (solvers/README.md, "Factors or iterations"), and iterates with a multigrid elsewhere and where the factor
/// does not fit. Plans that do not fit are left out, so the limit on memory holds for each of them.
///
/// @throws Error invalid_argument  method, preconditioner, operator and coupling that cannot go together
/// @throws Error out_of_memory     if none fits: what the most sparing one needs, and how many unknowns would
/// fit
std::vector<SolverPlan> solver_plans(const SizeForecast& size, const solvers::SolverOptions& options,
                                     double available);

/// Refuses a problem whose solution space, matrix or solution would not fit into memory, before any of it
/// exists.
/// @throws Error as `solver_plans`
/// @cost   that of `forecast_size`
void require_memory(const geometry::MultiPatch& model, const DirectionKnots& knots,
                    const std::vector<Material>& materials, Coupling coupling,
                    NonMatchingCoupling non_matching, const solvers::SolverOptions& options,
                    const solvers::Processes& processes);

}  // namespace isopatch::iga
