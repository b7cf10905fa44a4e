#pragma once

#include <string>

#include "app/run/study_run.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// The few lines that a person reads of a run: sizes, largest values, reactions, time, in engineering units.
std::string summary_text(const Study& study, const StudyRun& run);

/// A line with the first pairs of faces that meet without matching and the number of the others; "" for none.
std::string non_matching_text(const ModelReport& report);

}  // namespace isopatch::app
