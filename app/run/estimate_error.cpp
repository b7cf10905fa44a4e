#include "app/run/estimate_error.hpp"

#include <new>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "iga/estimate/error_estimate.hpp"
#include "iga/estimate/singular_places.hpp"

namespace isopatch::app {
namespace {

// A stress that is off by less than this share is no sign of one without a limit, wherever it is.
constexpr double least_singular_error = 0.05;

// The largest von Mises stress first, if it is anywhere, then the probes.
std::vector<iga::PatchPlace> places_of(const StudyRun& run) {
  std::vector<iga::PatchPlace> places;
  const iga::Extremum& most = run.solution.results.max_von_mises;
  if (most.patch >= 0) places.push_back({most.patch, most.parameter});
  for (const LocatedProbe& probe : run.built.probes) places.push_back({probe.patch, probe.parameter});
  return places;
}

void add_estimate(const Study& study, const iga::ElasticityProblem& problem, StudyRun& run,
                  const Progress& progress) {
  const std::vector<iga::PatchPlace> places = places_of(run);
  iga::ErrorEstimate estimate =
      iga::estimate_error(problem, run.solution.field, places, study.options, progress);
  run.error = RunError{estimate.energy, estimate.relative, Eigen::Matrix3d::Zero(), estimate.iterations};
  auto stress = estimate.stress_at.begin();
  const iga::Extremum& most = run.solution.results.max_von_mises;
  if (most.patch >= 0) {
    run.error->stress_at_max = *stress++;
    if (iga::von_mises(run.error->stress_at_max) > least_singular_error * most.value)
      run.error->singular = iga::singular_places(problem, places).front();
  }
  for (ProbeValues& probe : run.probes) probe.stress_error = *stress++;
  run.solution.field.errors = std::move(estimate.elements);
}

// What all processes come to alike.
bool is_common(ErrorCode code) {
  return code == ErrorCode::out_of_memory || code == ErrorCode::fold_over || code == ErrorCode::unsupported;
}

}  // namespace

void estimate_error(const Study& study, const iga::ElasticityProblem& problem, StudyRun& run,
                    const Progress& progress) {
  const Stopwatch watch;
  const bool is_alone = study.options.processes.count() == 1;
  try {
    add_estimate(study, problem, run, progress);
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
