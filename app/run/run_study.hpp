#pragma once

#include "app/run/study_run.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// Builds and solves a study with all its load cases. Nothing is written.
/// @throws Error as load_cases, build_problem, solve_elasticity and solve_cases do
StudyRun run_study(const Study& study, const Progress& progress = {});
/// The same on a model that is there already.
/// @param model  as `reported_model` gives it for the study, whatever its discretization
StudyRun run_study(const Study& study, const ReportedModel& model, const Progress& progress = {});

}  // namespace isopatch::app
