#include "app/results/run_summary.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace isopatch::app {
namespace {

std::vector<SummarizedRegion> regions_of(const std::vector<AppliedRegion>& caught) {
  std::vector<SummarizedRegion> result;
  for (const AppliedRegion& region : caught)
    result.push_back({region.key, region.kind, region.given, region.faces, region.total});
  return result;
}

// A case shows its own loads, a combination all.
void keep_loads_of_case(const std::vector<std::string>& of_case, std::vector<SummarizedRegion>& loads) {
  if (of_case.empty()) return;
  std::erase_if(loads, [&](const SummarizedRegion& load) {
    return std::find(of_case.begin(), of_case.end(), load.name) == of_case.end();
  });
}

std::optional<SummarizedPlace> place_of(const iga::Extremum& extremum, const geometry::MultiPatch& model) {
  if (extremum.patch < 0) return std::nullopt;
  return SummarizedPlace{"", extremum.patch, model.to_input(PatchId(extremum.patch), extremum.parameter)};
}

std::size_t index_of(const StudyRun& run, const CaseView& one) {
  for (std::size_t i = 0; i < run.further.size(); ++i)
    if (&run.further[i].solution == &one.solution) return i + 1;
  return 0;
}

}  // namespace

RunSummary summarized(const Study& study, const StudyRun& run) {
  return summarized(study, run, cases_of(run).front());
}

RunSummary summarized(const Study& study, const StudyRun& run, const CaseView& one) {
  const iga::ElasticityResults& results = one.solution.results;
  const geometry::MultiPatch& model = run.built.problem.discretization.model;
  RunSummary summary;
  summary.title = study.title;
  summary.study = study.source;
  summary.max_displacement = results.max_displacement.value;
  summary.max_von_mises = results.max_von_mises.value;
  summary.internal_energy = results.internal_energy;
  summary.unknowns = one.solution.size.dofs;
  summary.supports = regions_of(run.built.supports);
  for (std::size_t i = 0; i < summary.supports.size(); ++i)
    summary.supports[i].force = results.reactions[i].force;
  summary.loads = regions_of(run.built.loads);
  keep_loads_of_case(one.name.loads, summary.loads);
  summary.max_displacement_at = place_of(results.max_displacement, model);
  summary.max_von_mises_at = place_of(results.max_von_mises, model);
  for (const ProbeValues& probe : one.probes)
    summary.probes.push_back({probe.name, probe.patch, probe.parameter});
  summary.warnings = run.built.warnings;
  const solvers::SolveReport& solver = one.solution.solver;
  summary.solver = {std::string(solvers::name(solver.method)), study.options.solver.tolerance, solver.levels,
                    solver.residual_history};
  summary.levels = levels_of_case(run.levels, index_of(run, one));
  if (run.accuracy) summary.asked_error = run.accuracy->asked.energy;
  return summary;
}

}  // namespace isopatch::app
