#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run_study.hpp"

namespace isopatch::app {

/// Writes the files that a study asks for into its output directory, summary.json last: where it is, all is
/// there. What an earlier run wrote is removed before. Memory for the fields stays below some 50 MB;
/// results.h5 is put together in memory, 56 bytes per control point.
/// @param run  its timings get the phase "output", its warnings what is wrong with the fields
/// @return     the files that are not in a folder of their own, in the order in which they were written
/// @throws Error io
std::vector<std::string> write_results(const Study& study, StudyRun& run, const Progress& progress = {});

}  // namespace isopatch::app
