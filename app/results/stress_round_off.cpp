#include "app/results/stress_round_off.hpp"

#include <algorithm>

namespace isopatch::app {

double stress_round_off(const iga::ElasticityProblem& problem, const iga::ElasticityResults& results) {
  double young = 0;
  for (const iga::Material& material : problem.materials) young = std::max(young, iga::young(material));
  return 1e-10 * young * results.max_displacement.value / problem.discretization.model.size();
}

}  // namespace isopatch::app
