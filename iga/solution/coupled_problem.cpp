#include "iga/solution/coupled_problem.hpp"

#include "iga/post/internal_forces.hpp"
#include "iga/problem/loads.hpp"

namespace isopatch::iga {

CoupledProblem coupled_problem(const ElasticityProblem& problem, Coupling coupling, int points,
                               const solvers::Processes& processes) {
  CoupledProblem result;
  result.problem = &problem;
  result.coupling = coupling;
  result.points = points;
  result.processes = processes;
  result.global = global_nodes(problem.discretization);
  result.frames = support_frames(problem, result.global);
  result.multipliers = multiplier_rows(result.global, result.frames);
  result.load = load_vector(problem, points);
  result.spaces = isoparametric_spaces(problem.discretization);
  result.distribution = distribute(result.spaces, processes.count());
  result.parts = layers_of(result.distribution, result.spaces, processes.rank());
  result.thermal = thermal_strains(problem.temperatures, problem.materials);
  if (!result.thermal.empty()) {
    result.thermal_load =
        thermal_forces(problem.discretization, problem.materials, result.thermal, result.parts, points);
    if (processes.count() > 1)
      processes.sum(Eigen::Map<Eigen::VectorXd>(result.thermal_load.data(), result.thermal_load.size()));
    result.load += result.thermal_load;
  }
  return result;
}

}  // namespace isopatch::iga
