#pragma once

#include <functional>

#include "app/run/run_study.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// Solves a study as refined as it says, once more, twice more, ...
/// @param count  levels, 1 .. 11
/// @param keep   is given each finished level before the next one begins, so that it is not lost with that
/// @return  the finest one, with the figures of all in `levels`; those for which there is no memory are left
///          out with a warning, but for the first, and on several processes
/// @throws Error as run_study; invalid_argument for levels that cannot be
StudyRun run_levels(const Study& study, int count, const std::function<void(StudyRun&)>& keep,
                    const Progress& progress = {});

}  // namespace isopatch::app
