#include "app/run/study_run.hpp"

namespace isopatch::app {

std::vector<CaseView> cases_of(const StudyRun& run) {
  std::vector<CaseView> result = {{run.case_name, run.solution, run.probes, run.sections, run.error}};
  for (const CaseRun& other : run.further)
    result.push_back({other.name, other.solution, other.probes, other.sections, other.error});
  return result;
}

}  // namespace isopatch::app
