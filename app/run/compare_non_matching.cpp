#include "app/run/compare_non_matching.hpp"

#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "iga/estimate/error_estimate.hpp"

namespace isopatch::app {
namespace {

using iga::NonMatchingCoupling;
using solvers::Method;

double whole_energy(const iga::ElasticityResults& results) {
  return results.internal_energy + results.interface_energy;
}

// The options of the other way, with a method that suits it.
iga::ElasticityOptions other_options(iga::ElasticityOptions options) {
  const bool to_mortar = options.non_matching == NonMatchingCoupling::nitsche;
  options.non_matching = to_mortar ? NonMatchingCoupling::mortar : NonMatchingCoupling::nitsche;
  options.coupling = iga::Coupling::elimination;
  Method& method = options.solver.method;
  if (to_mortar && method == Method::cholmod) method = Method::mumps;
  if (!to_mortar && method == Method::minres) method = Method::cg;
  if (to_mortar && method == Method::cg) {
    options.solver.preconditioner = solvers::Preconditioner::multigrid;
    options.solver.form = solvers::Operator::automatic;
  }
  return options;
}

double largest_difference(const iga::ElasticField& a, const iga::ElasticField& b) {
  double difference = 0, size = 0;
  for (std::size_t p = 0; p < a.displacement.size(); ++p) {
    difference = larger(difference,
                        (a.displacement[p] - b.displacement[p]).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    size = larger(size, a.displacement[p].cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  return size > 0 ? difference / size : difference;
}

}  // namespace

double NonMatchingComparison::energy_difference() const {
  const double difference = std::abs(other_energy - energy);
  return energy > 0 ? difference / energy : difference;
}

NonMatchingComparison compare_non_matching(const iga::ElasticityProblem& problem,
                                           const iga::ElasticityOptions& options,
                                           const iga::ElasticitySolution& solution,
                                           const Progress& progress) {
  const iga::ElasticityOptions with_other = other_options(options);
  NonMatchingComparison result;
  result.own = options.non_matching;
  result.other = with_other.non_matching;
  result.energy = whole_energy(solution.results);
  try {
    const iga::ElasticitySolution other = iga::solve_elasticity(problem, with_other, progress);
    result.estimated_error = iga::estimate_error(problem, solution.field, {}, options, progress).relative;
    result.other_energy = whole_energy(other.results);
    result.displacement_difference = largest_difference(solution.field, other.field);
    result.solver = other.solver;
  } catch (const Error& error) {
    result.failure = error.what();
  }
  return result;
}

}  // namespace isopatch::app
