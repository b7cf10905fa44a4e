#include "app/run/compare_levels.hpp"

#include <fmt/format.h>

#include <new>
#include <optional>

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

// One level, or nothing and the reason if there is no memory for it.
std::optional<ComparedStudy> compare_if_it_fits(const Study& study, bool condition, std::string& reason,
                                                const Progress& progress) {
  try {
    return compare_couplings(study, condition, progress);
  } catch (const std::bad_alloc&) {
    reason = "out of memory";
  } catch (const Error& error) {
    if (error.code() != ErrorCode::out_of_memory) throw;
    reason = error.what();
  }
  return std::nullopt;
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
    const auto compared = may_fail ? compare_if_it_fits(level, options.condition, reason, progress)
                                   : std::optional(compare_couplings(level, options.condition, progress));
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
