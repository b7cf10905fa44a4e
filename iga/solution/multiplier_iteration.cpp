#include "iga/solution/multiplier_iteration.hpp"

#include "geometry/base/stopwatch.hpp"
#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/solution/saddle_point.hpp"
#include "solvers/load_sequence.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::iga {

using Eigen::VectorXd;

std::vector<DiscreteSolution> solve_with_multipliers(const CoupledProblem& coupled,
                                                     const solvers::SolverOptions& options,
                                                     const Progress& progress) {
  Stopwatch watch;
  const Level level =
      finest_level(coupled.spaces, coupled.global, coupled.frames, coupled.distribution, coupled.processes);
  const LevelOperator stiffness(level, coupled.problem->materials, coupled.points,
                                springs_of(*coupled.problem));
  const ElasticityMultigrid multigrid(*coupled.problem, level, coupled.frames, coupled.distribution,
                                      coupled.processes, {}, {options.multigrid, coupled.points}, progress);
  const SaddlePoint saddle(coupled, level, multigrid, stiffness.diagonal());
  solvers::OperatorSystem system;
  system.rows = saddle.rows();
  system.product = [&](const VectorXd& z) { return saddle.product(z); };
  system.preconditioner = [&](const VectorXd& r) { return saddle.preconditioned(r); };
  system.costs = {.levels = multigrid.levels(), .bytes = multigrid.bytes(), .setup_seconds = watch.lap()};
  solvers::LoadSequence sequence(system, solvers::KrylovMethod::minres);
  std::vector<DiscreteSolution> result;
  for (const RightSide& side : coupled.right_sides) {
    solvers::LinearSolution solved = sequence.solve(saddle.load(side), options, progress);
    result.push_back(
        {saddle.displacement(solved.x, side), saddle.multipliers(solved.x), std::move(solved.report)});
  }
  return result;
}

}  // namespace isopatch::iga
