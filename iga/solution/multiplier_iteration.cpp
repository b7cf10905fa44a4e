#include "iga/solution/multiplier_iteration.hpp"

#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/solution/saddle_point.hpp"
#include "solvers/operator_system.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::iga {

using Eigen::VectorXd;

NodalSolution solve_with_multipliers(const SolutionTask& task, const solvers::SolverOptions& options,
                                     const Progress& progress) {
  solvers::Stopwatch watch;
  const Level level =
      finest_level(task.problem.discretization, task.classes, task.frames, task.distribution, task.processes);
  const LevelOperator stiffness(level, task.problem.materials, task.points);
  const ElasticityMultigrid multigrid(
      task.problem, level, task.frames, task.distribution, task.processes,
      [&](const VectorXd& x) { return stiffness.apply(x); }, {options.multigrid, task.points}, progress);
  const SaddlePoint saddle(task, level, multigrid, stiffness.diagonal());
  solvers::OperatorSystem system;
  system.rows = saddle.rows();
  system.load = saddle.load();
  system.product = [&](const VectorXd& z) { return saddle.product(z); };
  system.preconditioner = [&](const VectorXd& r) { return saddle.preconditioned(r); };
  const double setup_seconds = watch.lap();
  solvers::LinearSolution solved = solve_with_minres(system, options, progress);
  NodalSolution result;
  result.report = std::move(solved.report);
  result.report.form = solvers::Operator::matrix_free;
  result.report.analysis_seconds = setup_seconds;
  result.report.levels = multigrid.levels();
  constexpr int vectors = 20;  // of PETSc, the multigrid's levels and operators
  result.report.memory_bytes = multigrid.bytes() + 8 * vectors * system.load.size();
  result.displacement = saddle.displacement(solved.x);
  result.multipliers = saddle.multipliers(solved.x);
  return result;
}

}  // namespace isopatch::iga
