#pragma once

#include <functional>

#include "app/run/run_study.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// Solves a study, halves the elements that its estimated errors come from, solves again, and so on until the
/// errors are as small as `study.accuracy` asks, the last refinement is used up or memory is short.
///
/// Elements are halved sheet by sheet (`iga::knots_to_add`), so neighbouring patches keep matching; where the
/// study couples faces that do not match, on one process and without temperatures, patch by patch. Of several
/// load cases the one farthest from its goal is looked at. A stress is known no better than its last change.
/// @param keep  is given each finished solution before the next one begins, so that it is not lost with that
/// @return  the last one, with the figures of all in `levels`, and in `accuracy` what was reached
/// @throws Error as run_study; invalid_argument for a probe that does not exist
StudyRun run_accuracy(const Study& study, const std::function<void(StudyRun&)>& keep,
                      const Progress& progress = {});

}  // namespace isopatch::app
