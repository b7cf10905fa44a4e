#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run/run_study.hpp"

namespace isopatch::app {

/// Writes the files that a study asks for into its output directory, in the place of those of an earlier run,
/// summary.json last: where it is, all is there. They are made in the folder "unfinished" there, results.h5
/// first; if one cannot be written, earlier results stay as they were and results.h5 is kept in that folder.
/// Memory for the fields stays below some 50 MB; results.h5 is put together in memory, 56 bytes per control
/// point.
/// @param run  its timings get the phase "output", its warnings what is wrong with the fields, which the
///             summary within results.h5 does not know yet
/// @return     the files that are not in a folder of their own, in the order in which they were written
/// @throws Error io, saying where the solution is if it could be written
std::vector<std::string> write_results(const Study& study, StudyRun& run, const Progress& progress = {});

}  // namespace isopatch::app
