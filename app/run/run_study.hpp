#pragma once

#include "app/run/study_run.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// Builds and solves a study. Nothing is written.
/// @throws Error as build_problem and solve_elasticity do
StudyRun run_study(const Study& study, const Progress& progress = {});

}  // namespace isopatch::app
