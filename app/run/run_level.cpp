#include "app/run/run_level.hpp"

#include <algorithm>

#include "app/run/study_run.hpp"

namespace isopatch::app {

bool is_even(const std::vector<RunLevel>& levels) {
  return std::none_of(levels.begin(), levels.end(), [](const RunLevel& level) { return level.is_adaptive; });
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
