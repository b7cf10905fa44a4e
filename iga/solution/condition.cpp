#include "iga/solution/condition.hpp"

#include "iga/solution/assembled_system.hpp"

namespace isopatch::iga {

solvers::ConditionEstimate estimate_condition(const ElasticityProblem& problem, Coupling coupling, int points,
                                              const Progress& progress) {
  const NodeClasses classes = node_classes(problem.discretization);
  const std::vector<SupportFrame> frames = support_frames(problem, classes);
  const std::vector<MultiplierRow> rows = multiplier_rows(classes, frames);
  const Eigen::Matrix3Xd load = Eigen::Matrix3Xd::Zero(3, problem.discretization.node_count());
  const solvers::Processes alone;
  const Distribution distribution = distribute(isoparametric_spaces(problem.discretization), alone.count());
  const SolutionTask task{problem, classes, frames, rows, load, distribution, alone, coupling, points};
  return solvers::estimate_condition(assembled_system(task, progress).system, progress);
}

}  // namespace isopatch::iga
