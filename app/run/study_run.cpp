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
  if (run.has_cases())
    for (const CaseView& one : cases_of(run)) {
      const iga::ElasticityResults& own = one.solution.results;
      level.cases.push_back({own.internal_energy, own.max_displacement.value, own.max_von_mises.value,
                             one.error ? std::optional(one.error->relative) : std::nullopt});
    }
  for (const iga::PhaseTime& time : run.timings) level.seconds += time.seconds;
  return level;
}

void add_coarser_levels(StudyRun& run) {
  double seconds = 0;
  for (std::size_t i = 0; i + 1 < run.levels.size(); ++i) seconds += run.levels[i].seconds;
  if (seconds > 0) run.timings.push_back({"coarser levels", seconds});
}

}  // namespace isopatch::app
