#pragma once

#include <string>

#include "app/run/study_run.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// The few lines that a person reads of a run: sizes, largest values, reactions, time, in engineering units.
std::string summary_text(const Study& study, const StudyRun& run);

}  // namespace isopatch::app
