#include "solvers/cg_solver.hpp"

#include "geometry/base/stopwatch.hpp"
#include "solvers/block_jacobi.hpp"
#include "solvers/block_product.hpp"
#include "solvers/internal/petsc_session.hpp"
#include "solvers/internal/restarts.hpp"
#include "solvers/scaled_system.hpp"

namespace isopatch::solvers {

LinearSolution solve_with_cg(const LinearSystem& system, const SolverOptions& options,
                             const Progress& progress) {
  using Eigen::VectorXd;
  start_petsc();
  Stopwatch watch;
  SolveReport report;
  report.method = Method::cg;
  progress("preconditioner", 0);
  const BlockJacobi jacobi(system.stiffness);
  constexpr int vectors = 12;  // of PETSc, of the restarts, and 3 for the inverted blocks
  report.memory_bytes = 8 * std::int64_t{vectors} * system.stiffness.rows();
  report.analysis_seconds = watch.lap();

  const SharedRows rows(system.stiffness.block_rows());
  const ScaledSystem scaled(system);
  // Loads of any size are solved for as one of length 1: squares must neither overflow nor vanish.
  const double load_norm = system.load.stableNorm();
  RestartedProblem problem{
      .rows = rows,
      .product = [&](const VectorXd& x) { return multiply(system.stiffness, x); },
      .preconditioner = [&](const VectorXd& r) { return jacobi.apply(r); },
      .residual = [&](const VectorXd& x) -> VectorXd { return scaled.residual(load_norm * x) / load_norm; },
      .error = [](const VectorXd& r) { return r.norm(); },
      .method = Krylov::conjugate_gradients,
      .norm = ErrorNorm::residual,
      .margin = 0.5};
  const RestartedSolution solved =
      iterate_with_restarts(problem, system.load / load_norm, 1, options, progress, report);
  report.solve_seconds = watch.lap();
  return {load_norm * solved.x, {}, std::move(report)};
}

}  // namespace isopatch::solvers
