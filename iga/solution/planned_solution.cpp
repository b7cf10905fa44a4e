#include "iga/solution/planned_solution.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "iga/solution/assembled_solution.hpp"
#include "iga/solution/iterative_solution.hpp"
#include "iga/solution/likely_cause.hpp"
#include "iga/solution/mortar_iteration.hpp"
#include "iga/solution/multiplier_iteration.hpp"

namespace isopatch::iga {
namespace {

using solvers::Method;
using solvers::Preconditioner;

// Iterations that stand in for factors have this many at most: what needs more does not converge.
constexpr int most_iterations_instead = 500;

// The plan replaces all that options leave open: nothing below this chooses.
std::vector<DiscreteSolution> solve_by(const SolverPlan& plan, const CoupledProblem& coupled,
                                       solvers::SolverOptions options, const Progress& progress) {
  options.method = plan.method;
  options.preconditioner = plan.preconditioner;
  options.form = plan.form;
  const bool iterates = plan.method == Method::minres || plan.method == Method::cg;
  if (iterates && !coupled.mortar.empty()) return solve_with_mortar(coupled, options, progress);
  if (plan.method == Method::minres) return solve_with_multipliers(coupled, options, progress);
  if (plan.method == Method::cg && plan.preconditioner == Preconditioner::multigrid)
    return solve_eliminated(coupled, options, progress);
  return solve_assembled(coupled, options, progress);
}

// Whether another method may succeed where one failed. Errors of one process alone end them all.
bool may_go_on(const Error& error, const CoupledProblem& coupled) {
  switch (error.code()) {
    case ErrorCode::not_converged:
      return true;
    case ErrorCode::singular_system:
      return !has_too_few_points(coupled.discretization(), coupled.points);
    case ErrorCode::out_of_memory:
    case ErrorCode::internal:
      return coupled.processes.count() == 1;
    default:
      return false;
  }
}

bool is_numerical(ErrorCode code) {
  return code == ErrorCode::not_converged || code == ErrorCode::singular_system;
}

std::string joined(const std::vector<std::string>& failures) {
  std::string text;
  for (const std::string& failure : failures) text += (text.empty() ? "" : "; ") + failure;
  return text;
}

}  // namespace

PlannedSolution solve_as_planned(const CoupledProblem& coupled, const std::vector<SolverPlan>& plans,
                                 const solvers::SolverOptions& options, const Progress& progress) {
  std::vector<std::string> failures;
  PlannedSolution result;
  for (const SolverPlan& plan : plans) {
    solvers::SolverOptions own = options;
    if (!failures.empty()) own.max_iterations = std::min(own.max_iterations, most_iterations_instead);
    try {
      result.predicted_bytes = std::max(result.predicted_bytes, plan.predicted_bytes);
      result.solutions = solve_by(plan, coupled, own, progress);
      result.is_first = failures.empty();
      for (DiscreteSolution& solution : result.solutions) {
        std::string& reason = solution.report.reason;
        const std::string remark = reason.empty() ? "" : "; " + reason;
        reason = (failures.empty() ? plan.reason : joined(failures) + "; so " + plan.reason) + remark;
      }
      return result;
    } catch (const Error& error) {
      failures.push_back(fmt::format("{} failed: {}", solvers::name(plan.method), error.what()));
      if (may_go_on(error, coupled) && &plan != &plans.back()) continue;
      const std::string cause =
          is_numerical(error.code()) ? "; " + likely_cause(*coupled.problem, coupled.points) : "";
      throw Error(error.code(),
                  (failures.size() == 1 ? std::string(error.what()) : joined(failures)) + cause);
    }
  }
  throw Error(ErrorCode::internal, "there is no plan to solve by");
}

}  // namespace isopatch::iga
