#include "app/run/estimate_error.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "iga/estimate/error_estimate.hpp"
#include "iga/estimate/singular_places.hpp"

namespace isopatch::app {
namespace {

// A stress that is off by less than this share is no sign of one without a limit, wherever it is.
constexpr double least_singular_error = 0.05;

// Solutions whose errors are estimated at once: six vectors of the raised space each.
constexpr std::size_t most_together = 5;

// One solution of a run, with what is to be filled in.
struct Estimated {
  iga::ElasticitySolution& solution;
  std::vector<ProbeValues>& probes;
  std::optional<RunError>& error;
};

std::vector<Estimated> solutions_of(StudyRun& run) {
  std::vector<Estimated> result = {{run.solution, run.probes, run.error}};
  for (CaseRun& other : run.further) result.push_back({other.solution, other.probes, other.error});
  return result;
}

// The largest von Mises stress first, if it is anywhere, then the probes.
std::vector<iga::PatchPlace> places_of(const BuiltProblem& built, const iga::ElasticityResults& results) {
  std::vector<iga::PatchPlace> places;
  const iga::Extremum& most = results.max_von_mises;
  if (most.patch >= 0) places.push_back({most.patch, most.parameter});
  for (const LocatedProbe& probe : built.probes) places.push_back({probe.patch, probe.parameter});
  return places;
}

// Where the error says that a stress may have no limit, the place is looked at.
std::optional<std::string> why_it_grows(const std::vector<std::optional<std::string>>& singular,
                                        std::size_t place, const Eigen::Matrix3d& error, double stress) {
  return iga::von_mises(error) > least_singular_error * stress ? singular[place] : std::nullopt;
}

// Beside the energy that is printed. That of the strains, which the estimate knows, is no measure where most
// of them are thermal; of a part that only grows next to nothing is left.
double share_of_energy(const iga::ErrorEstimate& estimate, const iga::ElasticityResults& results) {
  if (results.thermal_work == 0 || !(estimate.relative > 0)) return estimate.relative;
  const double of_strains = estimate.energy / (estimate.relative * estimate.relative);
  const double stored = results.internal_energy + results.support_energy + estimate.energy;
  return std::sqrt(estimate.energy / std::max(stored, 1e-6 * of_strains));
}

void add_estimate(const iga::ElasticityProblem& problem, const std::vector<iga::PatchPlace>& places,
                  iga::ErrorEstimate estimate, Estimated& of) {
  of.error = RunError{estimate.energy, share_of_energy(estimate, of.solution.results),
                      Eigen::Matrix3d::Zero(), estimate.iterations};
  const auto singular = iga::singular_places(problem, places);
  const iga::Extremum& most = of.solution.results.max_von_mises;
  std::size_t place = 0;
  if (most.patch >= 0) {
    of.error->stress_at_max = estimate.stress_at[place];
    of.error->singular = why_it_grows(singular, place, of.error->stress_at_max, most.value);
    ++place;
  }
  for (ProbeValues& probe : of.probes) {
    probe.stress_error = estimate.stress_at[place];
    probe.singular = why_it_grows(singular, place, *probe.stress_error, probe.values.von_mises);
    ++place;
  }
  of.solution.field.errors = std::move(estimate.elements);
}

// The loads of every case, then of every combination, in the estimator's space.
std::vector<Eigen::Matrix3Xd> loads_of(const iga::ErrorEstimator& estimator,
                                       const iga::ElasticityProblem& problem, const iga::LoadCases& cases) {
  if (cases.cases.empty()) return {estimator.loads(problem)};
  std::vector<Eigen::Matrix3Xd> result;
  for (const iga::LoadCase& one : cases.cases) result.push_back(estimator.loads(iga::of_case(problem, one)));
  for (const iga::LoadCombination& sum : cases.combinations) {
    Eigen::Matrix3Xd load = sum.factors[0] * result[0];
    for (std::size_t i = 1; i < sum.factors.size(); ++i) load += sum.factors[i] * result[i];
    result.push_back(std::move(load));
  }
  return result;
}

void add_estimates(const Study& study, const iga::LoadCases& cases, StudyRun& run, const Progress& progress) {
  const iga::ElasticityProblem& problem = run.built.problem;
  const iga::ErrorEstimator estimator(problem, study.options, progress);
  const std::vector<Eigen::Matrix3Xd> loads = loads_of(estimator, problem, cases);
  std::vector<Estimated> all = solutions_of(run);
  for (std::size_t first = 0; first < all.size(); first += most_together) {
    const std::size_t last = std::min(all.size(), first + most_together);
    std::vector<iga::SolutionToEstimate> some;
    for (std::size_t i = first; i < last; ++i)
      some.push_back({loads[i], all[i].solution.field, places_of(run.built, all[i].solution.results)});
    std::vector<iga::ErrorEstimate> estimates = estimator.estimates(some, progress);
    for (std::size_t i = first; i < last; ++i)
      add_estimate(problem, some[i - first].places, std::move(estimates[i - first]), all[i]);
  }
}

// What all processes come to alike.
bool is_common(ErrorCode code) {
  return code == ErrorCode::out_of_memory || code == ErrorCode::fold_over || code == ErrorCode::unsupported;
}

}  // namespace

void estimate_errors(const Study& study, const iga::LoadCases& cases, StudyRun& run,
                     const Progress& progress) {
  const Stopwatch watch;
  const bool is_alone = study.options.processes.count() == 1;
  try {
    add_estimates(study, cases, run, progress);
  } catch (const Error& error) {
    if (!is_alone && !is_common(error.code())) throw;
    run.error_missing = error.what();
  } catch (const std::bad_alloc&) {
    if (!is_alone) throw;
    run.error_missing = "out of memory";
  }
  run.timings.push_back({"error estimate", watch.seconds()});
}

}  // namespace isopatch::app
