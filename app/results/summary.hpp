#pragma once

#include <cstdint>
#include <string>

#include "app/base/provenance.hpp"
#include "app/run/run_study.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// summary.json of a run; SUMMARY.md documents its keys. SI units throughout.
std::string summary_json(const Study& study, const StudyRun& run);

/// The same with one phase more in its timings.
std::string with_phase(const std::string& summary, const iga::PhaseTime& time);

/// The few lines that a person reads: sizes, largest values, reactions, time, in engineering units.
std::string summary_text(const Study& study, const StudyRun& run);

}  // namespace isopatch::app
