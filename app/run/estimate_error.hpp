#pragma once

#include "app/run/study_run.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// Estimates the errors of a run's solutions and adds them: of the whole, of the elements, of the stress at
/// probes and where it is largest. All load cases and combinations share one set-up. Where they cannot be
/// estimated, the run says why and keeps its results.
/// @param cases  of the study; none where it has no load cases
/// @throws Error  on several processes, what one of them alone came to
void estimate_errors(const Study& study, const iga::LoadCases& cases, StudyRun& run,
                     const Progress& progress = {});

}  // namespace isopatch::app
