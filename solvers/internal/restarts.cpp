#include "solvers/internal/restarts.hpp"

#include <fmt/format.h>

#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::solvers {
namespace {

constexpr int most_restarts = 5;
// A restart that leaves more than this share of the error is the last one.
constexpr double least_gain = 0.9;

void check_energy(KSPConvergedReason reason, int iterations) {
  if (reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC)
    throw Error(ErrorCode::singular_system,
                fmt::format("the iteration met a direction without positive energy in step {}: the matrix is "
                            "singular or indefinite",
                            iterations));
}

}  // namespace

RestartedSolution iterate_with_restarts(const RestartedProblem& problem, const Eigen::VectorXd& right_side,
                                        double error, const SolverOptions& options, const Progress& progress,
                                        SolveReport& report) {
  RestartedSolution solution{Eigen::VectorXd::Zero(right_side.size()), right_side, error};
  report.residual_history.push_back(error);
  for (int restart = 0; restart <= most_restarts && solution.error > options.tolerance; ++restart) {
    const KrylovOptions krylov{problem.method, problem.norm,
                               problem.margin * options.tolerance / solution.error,
                               options.max_iterations - report.iterations};
    if (krylov.max_iterations <= 0) break;
    const KrylovSolution step =
        iterate(problem.rows, problem.product, problem.preconditioner, solution.residual, krylov, progress);
    for (std::size_t k = 1; k < step.errors.size(); ++k)
      report.residual_history.push_back(step.errors[k] * solution.error);
    report.iterations = static_cast<int>(report.residual_history.size()) - 1;
    check_energy(step.reason, report.iterations);
    solution.x += step.x;
    solution.residual = problem.residual(solution.x);
    const double before = std::exchange(solution.error, problem.error(solution.residual));
    report.residual_history.back() = solution.error;
    if (!(solution.error < least_gain * before)) break;
  }
  return solution;
}

}  // namespace isopatch::solvers
