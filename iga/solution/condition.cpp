#include "iga/solution/condition.hpp"

#include "iga/solution/assembled_system.hpp"

namespace isopatch::iga {

solvers::ConditionEstimate estimate_condition(const ElasticityProblem& problem, Coupling coupling, int points,
                                              const Progress& progress) {
  const CoupledProblem coupled = coupled_problem(problem, {.coupling = coupling, .points = points});
  return solvers::estimate_condition(assembled_system(coupled, progress).system, progress);
}

}  // namespace isopatch::iga
