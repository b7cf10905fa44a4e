#include "iga/solution/coupled_problem.hpp"

namespace isopatch::iga {
namespace {

// All but the right sides and the supports that they need.
CoupledProblem without_loads(const ElasticityProblem& problem, Coupling coupling, int points,
                             const solvers::Processes& processes) {
  CoupledProblem result;
  result.problem = &problem;
  result.coupling = coupling;
  result.points = points;
  result.processes = processes;
  result.global = global_nodes(problem.discretization);
  result.spaces = isoparametric_spaces(problem.discretization);
  result.distribution = distribute(result.spaces, processes.count());
  result.parts = layers_of(result.distribution, result.spaces, processes.rank());
  return result;
}

}  // namespace

CoupledProblem coupled_problem(const ElasticityProblem& problem, Coupling coupling, int points,
                               const solvers::Processes& processes) {
  CoupledProblem result = without_loads(problem, coupling, points, processes);
  result.frames = support_frames(problem, result.global);
  result.multipliers = multiplier_rows(result.global, result.frames);
  result.right_sides = {right_side(problem, result.global, result.frames, points)};
  return result;
}

CoupledProblem coupled_cases(const ElasticityProblem& problem, const std::vector<LoadCase>& cases,
                             Coupling coupling, int points, const solvers::Processes& processes) {
  CoupledProblem result = without_loads(problem, coupling, points, processes);
  for (const LoadCase& load_case : cases) {
    const ElasticityProblem own = of_case(problem, load_case);
    // Which directions are held does not depend on by how much.
    result.frames = support_frames(own, result.global);
    result.right_sides.push_back(right_side(own, result.global, result.frames, points));
  }
  result.multipliers = multiplier_rows(result.global, result.frames);
  return result;
}

}  // namespace isopatch::iga
