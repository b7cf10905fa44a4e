#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/base/error.hpp"
#include "solvers/internal/krylov.hpp"
#include "solvers/internal/petsc_session.hpp"
#include "solvers/operator_system.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::solvers {
namespace {

void check_reason(KSPConvergedReason reason, int iterations) {
  if (reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC)
    throw Error(ErrorCode::singular_system,
                fmt::format("the iteration met a direction without positive energy in step {}: the matrix is "
                            "singular or indefinite",
                            iterations));
}

// Round-off may leave a square a little below 0; what is no number stays none.
double error_of(const OperatorSystem& system, const Eigen::VectorXd& residual) {
  const double square = system.rows.dot(residual, system.preconditioner(residual));
  return square <= 0 ? 0 : std::sqrt(square);
}

// Entries of x with signs that follow no order but their numbers in the whole system.
Eigen::VectorXd with_rough_signs(Eigen::VectorXd x, const SharedRows& rows) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto row = static_cast<std::size_t>(i / 3);
    const auto number = 3 * (rows.is_distributed() ? rows.global_of_local()[row] : i / 3) + i % 3;
    if ((static_cast<std::uint32_t>(number) * 2654435761u) >> 31) x[i] = -x[i];
  }
  return x;
}

// The error that rounding x to doubles leaves: no iteration comes below it, where forces cancel inside a thin
// body.
double rounding_level(const OperatorSystem& system, const Eigen::VectorXd& x, double first) {
  return std::numeric_limits<double>::epsilon() *
         error_of(system, system.product(with_rough_signs(x, system.rows))) / first;
}

LinearSolution solve(const OperatorSystem& system, const SolverOptions& options, Krylov method,
                     const Progress& progress) {
  constexpr int most_restarts = 5;
  start_petsc();
  Stopwatch watch;
  LinearSolution solution;
  SolveReport& report = solution.report;
  report.method = method == Krylov::conjugate_gradients ? Method::cg : Method::minres;
  solution.x = Eigen::VectorXd::Zero(system.load.size());
  const double first = error_of(system, system.load);
  Eigen::VectorXd residual = system.load;
  if (!std::isfinite(first))
    throw Error(
        ErrorCode::not_converged,
        fmt::format("the load is {} in the norm of the preconditioner: a value that is not a number in the "
                    "load, the matrix or the preconditioner",
                    first));
  double relative = first > 0 ? 1 : 0;
  report.residual_history.push_back(relative);
  for (int restart = 0; restart <= most_restarts && relative > options.tolerance; ++restart) {
    // A little below the tolerance, for the true error is not quite the updated one.
    const KrylovOptions krylov{method, ErrorNorm::preconditioned, 0.8 * options.tolerance / relative,
                               options.max_iterations - report.iterations};
    if (krylov.max_iterations <= 0) break;
    const KrylovSolution step =
        iterate(system.rows, system.product, system.preconditioner, residual, krylov, progress);
    for (std::size_t k = 1; k < step.errors.size(); ++k)
      report.residual_history.push_back(step.errors[k] * relative);
    report.iterations = static_cast<int>(report.residual_history.size()) - 1;
    check_reason(step.reason, report.iterations);
    solution.x += step.x;
    residual = system.load - system.product(solution.x);
    const double before = std::exchange(relative, error_of(system, residual) / first);
    report.residual_history.back() = relative;
    if (!(relative < 0.9 * before)) break;
  }
  report.energy_error = relative;
  report.relative_residual =
      first > 0 ? std::sqrt(system.rows.dot(residual, residual) / system.rows.dot(system.load, system.load))
                : 0;
  report.solve_seconds = watch.lap();
  constexpr double tolerance_of_round_off = 1e-12;  // who asks for less wants to know that it was not reached
  if (relative > options.tolerance && options.tolerance >= tolerance_of_round_off) {
    constexpr double worst_rounding_level = 1e-6;
    const double level = rounding_level(system, solution.x, first);
    if (level <= worst_rounding_level && relative <= level) {
      report.reason = fmt::format("the relative error of {:.1e} is what double precision allows", relative);
      return solution;
    }
  }
  if (!(relative <= options.tolerance) || !std::isfinite(report.relative_residual))
    throw Error(
        ErrorCode::not_converged,
        fmt::format("method '{}' reached a relative error of {:.3e} instead of {:.3e} after {} iterations; "
                    "raise max_iterations, loosen the tolerance, or use a direct method",
                    name(report.method), relative, options.tolerance, report.iterations));
  return solution;
}

}  // namespace

LinearSolution solve_with_cg(const OperatorSystem& system, const SolverOptions& options,
                             const Progress& progress) {
  return solve(system, options, Krylov::conjugate_gradients, progress);
}

LinearSolution solve_with_minres(const OperatorSystem& system, const SolverOptions& options,
                                 const Progress& progress) {
  return solve(system, options, Krylov::minimal_residuals, progress);
}

}  // namespace isopatch::solvers
