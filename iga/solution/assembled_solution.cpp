#include "iga/solution/assembled_solution.hpp"

#include <utility>

#include "iga/solution/assembled_system.hpp"
#include "solvers/solve.hpp"

namespace isopatch::iga {
namespace {

DiscreteSolution at_nodes(const CoupledProblem& coupled, const AssembledSystem& assembled, std::size_t side,
                          solvers::LinearSolution linear) {
  const solvers::LinearSystem& system = assembled.system;
  DiscreteSolution result;
  result.report = std::move(linear.report);
  const Eigen::Index of_mortar = Eigen::Index{coupled.mortar.rows()};
  const Eigen::VectorXd multipliers = system.multiplier_rows.whole(linear.multipliers);
  result.mortar = multipliers.tail(of_mortar);
  if (coupled.coupling == Coupling::lagrange)
    result.multipliers = multipliers.head(multipliers.size() - of_mortar);
  const Eigen::Matrix3Xd of_rows =
      displacement_of_rows(system.rows.whole(linear.x), assembled.frame_of_row, assembled.prescribed[side]);
  result.displacement.resize(3, coupled.discretization().node_count());
  for (Eigen::Index node = 0; node < result.displacement.cols(); ++node)
    result.displacement.col(node) =
        of_rows.col(assembled.numbering.row_of_node[static_cast<std::size_t>(node)]);
  return result;
}

}  // namespace

std::vector<DiscreteSolution> solve_assembled(const CoupledProblem& coupled,
                                              const solvers::SolverOptions& options,
                                              const Progress& progress) {
  const AssembledSystem assembled = assembled_system(coupled, progress);
  std::vector<solvers::LinearSolution> linear =
      solvers::solve_each(assembled.system, assembled.loads, options, progress);
  std::vector<DiscreteSolution> result;
  for (std::size_t i = 0; i < linear.size(); ++i)
    result.push_back(at_nodes(coupled, assembled, i, std::move(linear[i])));
  return result;
}

}  // namespace isopatch::iga
