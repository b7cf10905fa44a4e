#pragma once

#include <string>
#include <vector>

#include "app/problem/build_problem.hpp"
#include "app/run/case_run.hpp"
#include "geometry/base/progress.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::app {

/// A study's solution with all that was known on the way. Of a study with load cases `solution` and `probes`
/// are those of the first.
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

  bool has_cases() const { return !case_name.name.empty(); }
};

/// One case of a run, which must outlive it.
struct CaseView {
  const CaseName& name;
  const iga::ElasticitySolution& solution;
  const std::vector<ProbeValues>& probes;
  const std::vector<SectionValues>& sections;
};

/// The case of `solution`, then the others; one alone of a study without cases.
std::vector<CaseView> cases_of(const StudyRun& run);

/// Builds and solves a study with all its load cases. Nothing is written.
/// @throws Error as load_cases, build_problem, solve_elasticity and solve_cases do
StudyRun run_study(const Study& study, const Progress& progress = {});

}  // namespace isopatch::app
