#include "app/run/run_levels.hpp"

#include <fmt/format.h>

#include <optional>

#include "app/run/compare_levels.hpp"
#include "app/run/if_it_fits.hpp"

namespace isopatch::app {
StudyRun run_levels(const Study& study, int count, const std::function<void(StudyRun&)>& keep,
                    const Progress& progress) {
  std::vector<RunLevel> levels;
  std::optional<StudyRun> finest;
  const auto discretizations = level_discretizations(study, {.count = count});
  const ReportedModel model = reported_model(study, progress);
  for (const iga::DiscretizationOptions& discretization : discretizations) {
    if (finest) keep(*finest);
    Study level = study;
    level.discretization = discretization;
    const bool may_fail = finest && study.options.processes.count() == 1;
    std::string reason;
    const auto solve = [&] { return run_study(level, model, progress); };
    std::optional<StudyRun> run = may_fail ? if_it_fits(solve, reason) : std::optional(solve());
    if (!run) {
      finest->built.warnings.push_back(
          {fmt::format("no memory for refine = {}; the results are those of the level before: {}",
                       discretization.refine, reason)});
      break;
    }
    levels.push_back(run_level(*run, discretization.refine));
    finest = std::move(run);
    if (count > 1) finest->levels = levels;
  }
  add_coarser_levels(*finest);
  return std::move(*finest);
}

}  // namespace isopatch::app
