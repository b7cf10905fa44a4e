#include "solvers/cg_solver.hpp"

#include "geometry/base/stopwatch.hpp"
#include "solvers/block_jacobi.hpp"
#include "solvers/block_product.hpp"
#include "solvers/internal/petsc_session.hpp"
#include "solvers/internal/restarts.hpp"
#include "solvers/scaled_system.hpp"

namespace isopatch::solvers {

std::vector<LinearSolution> solve_with_cg(const ScaledSystems& systems, const SolverOptions& options,
                                          const Progress& progress) {
  using Eigen::VectorXd;
  start_petsc();
  Stopwatch watch;
  const LinearSystem& system = systems.front().system();
  SolveReport first;
  first.method = Method::cg;
  progress("preconditioner", 0);
  const BlockJacobi jacobi(system.stiffness);
  constexpr int vectors = 12;  // of PETSc, of the restarts, and 3 for the inverted blocks
  first.memory_bytes = 8 * std::int64_t{vectors} * system.stiffness.rows();
  first.analysis_seconds = watch.lap();

  const SharedRows rows(system.stiffness.block_rows());
  std::vector<LinearSolution> result;
  for (const ScaledSystem& scaled : systems) {
    // Loads of any size are solved for as one of length 1: squares must neither overflow nor vanish.
    const double load_norm = scaled.load().stableNorm();
    const RestartedProblem problem{
        .rows = rows,
        .product = [&](const VectorXd& x) { return multiply(system.stiffness, x); },
        .preconditioner = [&](const VectorXd& r) { return jacobi.apply(r); },
        .residual = [&](const VectorXd& x) -> VectorXd { return scaled.residual(load_norm * x) / load_norm; },
        .error = [](const VectorXd& r) { return r.norm(); },
        .method = Krylov::conjugate_gradients,
        .norm = ErrorNorm::residual,
        .margin = 0.5};
    SolveReport report = first;
    const RestartedSolution solved =
        iterate_with_restarts(problem, scaled.load() / load_norm, 1, options, progress, report);
    report.solve_seconds = watch.lap();
    result.push_back({load_norm * solved.x, {}, std::move(report)});
  }
  return result;
}

}  // namespace isopatch::solvers
