#pragma once

#include "app/run/study_run.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// Estimates the error of a solution and adds it: of the whole, of the elements, of the stress at probes and
/// where it is largest. Where it cannot be, the run says why and keeps its results.
/// @throws Error  on several processes, what one of them alone came to
/// @param problem  with the loads of the solution alone, where the run has load cases
void estimate_error(const Study& study, const iga::ElasticityProblem& problem, StudyRun& run,
                    const Progress& progress = {});

}  // namespace isopatch::app
