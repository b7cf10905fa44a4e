#include "app/run/run_levels.hpp"

#include <fmt/format.h>

#include <optional>

#include "app/run/compare_levels.hpp"
#include "app/run/if_it_fits.hpp"

namespace isopatch::app {
namespace {

RunLevel level_of(const StudyRun& run, int refine) {
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

}  // namespace

StudyRun run_levels(const Study& study, int count, const std::function<void(StudyRun&)>& keep,
                    const Progress& progress) {
  std::vector<RunLevel> levels;
  std::optional<StudyRun> finest;
  for (const iga::DiscretizationOptions& discretization : level_discretizations(study, {.count = count})) {
    if (finest) keep(*finest);
    Study level = study;
    level.discretization = discretization;
    const bool may_fail = finest && study.options.processes.count() == 1;
    std::string reason;
    const auto run_level = [&] { return run_study(level, progress); };
    std::optional<StudyRun> run = may_fail ? if_it_fits(run_level, reason) : std::optional(run_level());
    if (!run) {
      finest->built.warnings.push_back(
          {fmt::format("no memory for refine = {}; the results are those of the level before: {}",
                       discretization.refine, reason)});
      break;
    }
    levels.push_back(level_of(*run, discretization.refine));
    finest = std::move(run);
    if (count > 1) finest->levels = levels;
  }
  return std::move(*finest);
}

}  // namespace isopatch::app
