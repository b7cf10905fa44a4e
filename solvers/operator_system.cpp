#include "solvers/operator_system.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "solvers/internal/petsc_session.hpp"
#include "solvers/internal/restarts.hpp"

namespace isopatch::solvers {
namespace {

// Round-off may leave a square a little below 0; what is no number stays none.
double error_of(const OperatorSystem& system, const Eigen::VectorXd& residual) {
  const double square = system.rows.dot(residual, system.preconditioner(residual));
  return square <= 0 ? 0 : std::sqrt(square);
}

// Entries of x with signs that follow no order but their numbers in the whole system.
Eigen::VectorXd with_rough_signs(Eigen::VectorXd x, const SharedRows& rows) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto row = static_cast<std::size_t>(i / block_size);
    const auto number =
        block_size * (rows.is_distributed() ? rows.global_of_local()[row] : i / block_size) + i % block_size;
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

void check_load(double error) {
  if (std::isfinite(error)) return;
  throw Error(
      ErrorCode::not_converged,
      fmt::format("the load is {} in the norm of the preconditioner: a value that is not a number in the "
                  "load, the matrix or the preconditioner",
                  error));
}

double relative_residual(const OperatorSystem& system, const Eigen::VectorXd& residual) {
  return std::sqrt(system.rows.dot(residual, residual) / system.rows.dot(system.load, system.load));
}

LinearSolution solve(const OperatorSystem& system, const SolverOptions& options, Krylov method,
                     const Progress& progress) {
  start_petsc();
  Stopwatch watch;
  LinearSolution solution;
  SolveReport& report = solution.report;
  report = first_report(system, method == Krylov::conjugate_gradients ? Method::cg : Method::minres);
  const double first = error_of(system, system.load);
  check_load(first);
  const RestartedProblem problem{
      .rows = system.rows,
      .product = system.product,
      .preconditioner = system.preconditioner,
      .residual = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        return system.load - system.product(x);
      },
      .error = [&](const Eigen::VectorXd& r) { return error_of(system, r) / first; },
      .method = method,
      .norm = ErrorNorm::preconditioned,
      .margin = 0.8};
  RestartedSolution solved =
      iterate_with_restarts(problem, system.load, first > 0 ? 1 : 0, options, progress, report);
  solution.x = std::move(solved.x);
  const double relative = solved.error;
  report.energy_error = relative;
  report.relative_residual = first > 0 ? relative_residual(system, solved.residual) : 0;
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

SolveReport first_report(const OperatorSystem& system, Method method) {
  constexpr int vectors = 20;  // of PETSc, of the preconditioner and of the products
  const OperatorCosts& costs = system.costs;
  SolveReport report;
  report.method = method;
  report.form = costs.form;
  report.levels = costs.levels;
  report.matrix_nonzeros = costs.matrix_nonzeros;
  report.memory_bytes = costs.bytes + 8 * vectors * system.load.size();
  report.assembly_seconds = costs.assembly_seconds;
  report.analysis_seconds = costs.setup_seconds;
  return report;
}

LinearSolution solve_with_cg(const OperatorSystem& system, const SolverOptions& options,
                             const Progress& progress) {
  return solve(system, options, Krylov::conjugate_gradients, progress);
}

LinearSolution solve_with_minres(const OperatorSystem& system, const SolverOptions& options,
                                 const Progress& progress) {
  return solve(system, options, Krylov::minimal_residuals, progress);
}

}  // namespace isopatch::solvers
