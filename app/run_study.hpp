#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/build_problem.hpp"
#include "geometry/base/progress.hpp"
#include "iga/solve_elasticity.hpp"

namespace isopatch::app {

/// Values at a probe.
struct ProbeValues {
  std::string name;
  int patch = 0;
  geometry::Parameter<3> parameter;  ///< in the input's naming
  iga::FieldValues values;
};

/// A study's solution with all that was known on the way.
struct StudyRun {
  BuiltProblem built;
  iga::ElasticitySolution solution;
  std::vector<ProbeValues> probes;
  std::vector<iga::PhaseTime> timings;  ///< of all phases so far, s
};

/// Builds and solves a study. Nothing is written.
/// @throws Error as build_problem and solve_elasticity do
StudyRun run_study(const Study& study, const Progress& progress = {});

/// A file that is to be written, its path relative to the output directory.
struct OutputFile {
  std::filesystem::path path;
  std::string bytes;
};

/// The files of a run in the order in which they are written, summary.json last: where it is, all is there.
std::vector<OutputFile> output_files(const Study& study, StudyRun& run, const Progress& progress = {});

/// The fields for ParaView: fields/patch_000.vtu, ... and their collection results.vtm.
std::vector<OutputFile> field_files(const iga::ElasticField& field, const Progress& progress = {});

/// Refuses a directory that could not be written, before any long work. Leaves the file system as it was.
/// @throws Error io, naming the directory and the reason
void check_writable(const std::filesystem::path& directory);

/// Removes what an earlier run wrote and this one does not replace, and first of all its summary, which would
/// vouch for files that are being replaced. Leaves all other files alone.
void remove_earlier_results(const std::filesystem::path& directory, const std::vector<OutputFile>& files);

/// Writes files, making their folders; each appears whole or not at all.
/// @throws Error io
void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files);

}  // namespace isopatch::app
