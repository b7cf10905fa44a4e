#pragma once

#include <string>

#include "app/run/run_study.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// summary.json of a run; SUMMARY.md documents its keys. SI units throughout. The same run gives the same
/// text; the phases are those that its timings have.
std::string summary_json(const Study& study, const StudyRun& run);

}  // namespace isopatch::app
