#include "app/run/run_study.hpp"

#include "app/base/provenance.hpp"
#include "app/problem/plausibility.hpp"
#include "app/run/estimate_error.hpp"
#include "geometry/base/stopwatch.hpp"

namespace isopatch::app {
namespace {

// A place in the model that was found is on the other side's face to a share of the tolerance of interfaces.
void add_sides(StudyRun& run) {
  const geometry::MultiPatch& model = run.built.problem.discretization.model;
  const iga::ElasticField& field = run.solution.field;
  for (ProbeValues& probe : run.probes)
    for (const iga::Location& side :
         iga::locate_sides(field, probe.values.place, model.tolerance().same_point * model.size()))
      if (const auto p = static_cast<std::size_t>(side.patch);
          field.materials[p] != field.materials[static_cast<std::size_t>(probe.patch)])
        probe.sides.push_back({side.patch, model.to_input(PatchId(side.patch), side.parameter),
                               field.materials[p].name, iga::evaluate(field, side.patch, side.parameter)});
}

}  // namespace

StudyRun run_study(const Study& study, const Progress& progress) {
  const Stopwatch building;
  StudyRun run{build_problem(study, progress), {}, {}, {}, 0};
  run.timings.push_back({"model", building.seconds()});
  run.solution = iga::solve_elasticity(run.built.problem, study.options, progress);
  for (const iga::PhaseTime& time : run.solution.timings) run.timings.push_back(time);
  const auto& model = run.built.problem.discretization.model;
  for (const LocatedProbe& probe : run.built.probes)
    run.probes.push_back({probe.name, probe.patch, model.to_input(PatchId(probe.patch), probe.parameter),
                          iga::evaluate(run.solution.field, probe.patch, probe.parameter)});
  add_sides(run);
  if (study.output.error_estimate) estimate_error(study, run, progress);
  for (Warning& warning : result_warnings(run.built, run.solution))
    run.built.warnings.push_back(std::move(warning));
  run.peak_bytes = study.options.processes.sum(peak_memory_bytes());
  return run;
}

}  // namespace isopatch::app
