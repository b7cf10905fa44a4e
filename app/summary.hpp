#pragma once

#include <cstdint>
#include <string>

#include "app/run_study.hpp"
#include "app/study.hpp"

namespace isopatch::app {

/// summary.json of a run; SUMMARY.md documents its keys. SI units throughout.
std::string summary_json(const Study& study, const StudyRun& run);

/// The same with one phase more in its timings.
std::string with_phase(const std::string& summary, const iga::PhaseTime& time);

/// The few lines that a person reads: sizes, largest values, reactions, time, in engineering units.
std::string summary_text(const Study& study, const StudyRun& run);

/// Most memory that this process has held so far, from the operating system.
std::int64_t peak_memory_bytes();

/// Version of the program.
std::string_view version();

}  // namespace isopatch::app
