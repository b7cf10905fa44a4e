#include "solvers/cg_solver.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "solvers/block_jacobi.hpp"
#include "solvers/block_product.hpp"
#include "solvers/internal/krylov.hpp"
#include "solvers/internal/petsc_session.hpp"
#include "solvers/scaled_system.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::solvers {
namespace {

void check_reason(KSPConvergedReason reason, int iterations) {
  if (reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC)
    throw Error(
        ErrorCode::singular_system,
        fmt::format(
            "conjugate gradients met a direction without positive energy in iteration {}: the matrix is "
            "singular or indefinite",
            iterations));
}

// Iterates, and starts again from the true residual as long as that helps. Fills in the report.
Eigen::VectorXd iterate(const LinearOperator& product, const LinearOperator& precondition,
                        const LinearSystem& system, const SolverOptions& options, const Progress& progress,
                        SolveReport& report) {
  constexpr int most_restarts = 5;
  const ScaledSystem scaled(system);
  const double load_norm = system.load.stableNorm();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.load.size());
  Eigen::VectorXd residual =
      system.load / load_norm;  // of any size, but squares must neither overflow nor vanish
  double relative = 1;
  report.residual_history.push_back(relative);
  for (int restart = 0; restart <= most_restarts && relative > options.tolerance; ++restart) {
    // A little below the tolerance, for the true residual is not quite the updated one.
    const KrylovOptions krylov{Krylov::conjugate_gradients, ErrorNorm::residual,
                               0.5 * options.tolerance / relative,
                               options.max_iterations - report.iterations};
    if (krylov.max_iterations <= 0) break;
    const KrylovSolution step = solvers::iterate(SharedRows(system.stiffness.block_rows()), product,
                                                 precondition, residual, krylov, progress);
    for (std::size_t k = 1; k < step.errors.size(); ++k)
      report.residual_history.push_back(step.errors[k] * relative);
    report.iterations = static_cast<int>(report.residual_history.size()) - 1;
    check_reason(step.reason, report.iterations);
    x += load_norm * step.x;
    residual = scaled.residual(x) / load_norm;
    const double before = std::exchange(relative, residual.norm());
    report.residual_history.back() = relative;
    if (!(relative < 0.9 * before)) break;
  }
  return x;
}

}  // namespace

LinearSolution solve_with_cg(const LinearSystem& system, const SolverOptions& options,
                             const Progress& progress) {
  start_petsc();
  Stopwatch watch;
  SolveReport report;
  report.method = Method::cg;
  progress("preconditioner", 0);
  const BlockJacobi jacobi(system.stiffness);
  const LinearOperator product = [&](const Eigen::VectorXd& x) { return multiply(system.stiffness, x); };
  const LinearOperator precondition = [&](const Eigen::VectorXd& r) { return jacobi.apply(r); };
  constexpr int vectors = 12;  // of PETSc, of the restarts, and 3 for the inverted blocks
  report.memory_bytes = 8 * std::int64_t{vectors} * system.stiffness.rows();
  report.analysis_seconds = watch.lap();

  Eigen::VectorXd x = iterate(product, precondition, system, options, progress, report);
  report.solve_seconds = watch.lap();
  return {std::move(x), {}, std::move(report)};
}

}  // namespace isopatch::solvers
