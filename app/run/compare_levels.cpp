#include "app/run/compare_levels.hpp"

#include <fmt/format.h>

#include <optional>

#include "app/run/if_it_fits.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

constexpr int most_levels = 11;

void check(const LevelOptions& options) {
  if (options.count < 1 || options.count > most_levels)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--levels is {}; its range is 1 .. {}", options.count, most_levels));
  for (const int degree : options.degrees)
    if (degree < 1 || degree > 10)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("--degrees has {}; the range of each is 1 .. 10", degree));
}

}  // namespace

std::vector<iga::DiscretizationOptions> level_discretizations(const Study& study,
                                                              const LevelOptions& options) {
  check(options);
  std::vector<iga::DiscretizationOptions> result;
  const std::size_t rounds = std::max<std::size_t>(1, options.degrees.size());
  for (std::size_t round = 0; round < rounds; ++round) {
    for (int level = 0; level < options.count; ++level) {
      iga::DiscretizationOptions discretization = study.discretization;
      discretization.refine += level;
      if (!options.degrees.empty()) discretization.degree.fill(options.degrees[round]);
      iga::validate(discretization);
      result.push_back(discretization);
    }
  }
  return result;
}

LevelReport compare_levels(
    const Study& study, const LevelOptions& options,
    const std::function<void(const ComparedStudy&, const std::vector<CouplingComparison>&)>& finished,
    const Progress& progress) {
  LevelReport report;
  for (const iga::DiscretizationOptions& discretization : level_discretizations(study, options)) {
    Study level = study;
    level.discretization = discretization;
    const bool may_fail = !report.levels.empty() && study.options.processes.count() == 1;
    std::string reason;
    const auto compare = [&] { return compare_couplings(level, options.condition, progress); };
    const auto compared = may_fail ? if_it_fits(compare, reason) : std::optional(compare());
    if (!compared) {
      report.stopped = fmt::format("no memory for refine = {}, and coarser levels are finished: {}",
                                   discretization.refine, reason);
      return report;
    }
    report.levels.push_back(compared->comparison);
    finished(*compared, report.levels);
  }
  return report;
}

}  // namespace isopatch::app
