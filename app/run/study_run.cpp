#include "app/run/study_run.hpp"

namespace isopatch::app {

std::vector<CaseView> cases_of(const StudyRun& run) {
  std::vector<CaseView> result = {{run.case_name, run.solution, run.probes, run.sections, run.error}};
  for (const CaseRun& other : run.further)
    result.push_back({other.name, other.solution, other.probes, other.sections, other.error});
  return result;
}

RunLevel run_level(const StudyRun& run, int refine) {
  const iga::ElasticityResults& results = run.solution.results;
  RunLevel level{.refine = refine,
                 .unknowns = run.solution.size.dofs,
                 .internal_energy = results.internal_energy,
                 .max_displacement = results.max_displacement.value,
                 .max_von_mises = results.max_von_mises.value};
  if (run.error) level.error = run.error->relative;
  for (const iga::PhaseTime& time : run.timings) level.seconds += time.seconds;
  return level;
}

}  // namespace isopatch::app
