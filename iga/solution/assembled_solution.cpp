#include "iga/solution/assembled_solution.hpp"

#include "iga/solution/assembled_system.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::iga {

NodalSolution solve_assembled(const SolutionTask& task, const solvers::SolverOptions& options,
                              const Progress& progress) {
  solvers::Stopwatch watch;
  const AssembledSystem assembled = assembled_system(task, progress);
  const solvers::LinearSystem& system = assembled.system;
  const double assembly_seconds = watch.lap();

  solvers::LinearSolution linear = solvers::solve(system, options, progress);
  NodalSolution result;
  result.report = std::move(linear.report);
  result.report.assembly_seconds = assembly_seconds;
  if (task.coupling == Coupling::lagrange)
    result.multipliers = system.multiplier_rows.whole(linear.multipliers);
  const Eigen::Matrix3Xd of_rows = displacement_of_rows(system.rows.whole(linear.x), assembled.frame_of_row);
  result.displacement.resize(3, task.problem.discretization.node_count());
  for (Eigen::Index node = 0; node < result.displacement.cols(); ++node)
    result.displacement.col(node) =
        of_rows.col(assembled.numbering.row_of_node[static_cast<std::size_t>(node)]);
  return result;
}

}  // namespace isopatch::iga
