#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/problem/build_problem.hpp"
#include "app/run/case_run.hpp"
#include "app/run/run_level.hpp"
#include "app/study/accuracy_input.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// What a run with [accuracy] came to.
struct AccuracyOutcome {
  AccuracyInput asked;
  std::string missing = {};  ///< why the goal is not reached; "" where it is
};

/// A study's solution with all that was known on the way. Of a study with load cases `solution`, `probes` and
/// `error` are those of the first.
struct StudyRun {
  BuiltProblem built;
  iga::ElasticitySolution solution;
  std::vector<ProbeValues> probes;
  std::vector<iga::PhaseTime> timings;  ///< of all phases so far, s
  std::int64_t peak_bytes =
      0;                    ///< most memory that all processes held until the end of these phases, added up
  CaseName case_name = {};  ///< of the solution
  std::vector<CaseRun> further = {};         ///< the other cases, then the combinations
  std::vector<SectionValues> sections = {};  ///< of the solution
  std::optional<RunError> error = {};        ///< of the solution, if it was asked for and could be estimated
  std::string error_missing = {};            ///< why no case has one though they were asked for
  std::vector<RunLevel> levels = {};         ///< of a run on several, this one the last
  std::optional<AccuracyOutcome> accuracy = {};  ///< of a run that was refined until it is accurate

  bool has_cases() const { return !case_name.name.empty(); }
};

/// @param refine  as `RunLevel` has it
RunLevel run_level(const StudyRun& run, int refine);

/// Adds the time of all levels but the last, which this run is, to its timings: the phases are of all then.
void add_coarser_levels(StudyRun& run);

/// One case of a run, which must outlive it.
struct CaseView {
  const CaseName& name;
  const iga::ElasticitySolution& solution;
  const std::vector<ProbeValues>& probes;
  const std::vector<SectionValues>& sections;
  const std::optional<RunError>& error;
};

/// The case of `solution`, then the others; one alone of a study without cases.
std::vector<CaseView> cases_of(const StudyRun& run);

}  // namespace isopatch::app
