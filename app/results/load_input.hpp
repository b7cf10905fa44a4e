#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/problem/selection.hpp"
#include "app/results/run_summary.hpp"
#include "geometry/base/guarded_process.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/output/result_file.hpp"

namespace isopatch::app {

/// How CAD files are read, as commands take it.
struct CadReading {
  bool allow_partial = false;
  double time_limit = 0;    ///< s; 0 for the default
  double memory_limit = 0;  ///< bytes; 0 for the default
};

/// What a command is asked to look at: patches (.xml, .g2, .mesh), a study (.toml) or results (.h5).
struct InputFile {
  std::filesystem::path path;
  std::vector<std::string> overrides;  ///< --set, for a study
  std::string length_unit;             ///< for files that do not say it; "" is m
  CadReading reading = {};             ///< of STEP, IGES and .brep files
  std::string case_name = {};          ///< of results: a load case; "": the first
};

/// Fills in how a command wants CAD files read.
template <class Target>
void set_reading(const CadReading& reading, Target& target) {
  target.allow_partial = reading.allow_partial;
  target.limits = {reading.time_limit, static_cast<std::uint64_t>(reading.memory_limit)};
}

/// Metres that one unit of the file measures.
/// @throws Error invalid_argument for a text that is no length
double length_unit(const InputFile& input);

/// Its model, in m, connected; and the results if it has any.
struct LoadedInput {
  geometry::MultiPatch model;
  std::optional<iga::StoredResult> result;
  std::string title;                       ///< of the study; otherwise the file's name
  std::optional<RunSummary> summary = {};  ///< of the results
  std::vector<FaceSelection> held = {};    ///< faces of the study's supports
  std::vector<FaceSelection> loaded = {};  ///< and of its loads
};

/// @throws Error as the readers and `connect` do; invalid_argument for a length unit that is none
LoadedInput load_input(const InputFile& input);

}  // namespace isopatch::app
