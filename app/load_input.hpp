#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/selection.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/result_file.hpp"

namespace isopatch::app {

/// What a command is asked to look at: patches (.xml, .g2, .mesh), a study (.toml) or results (.h5).
struct InputFile {
  std::filesystem::path path;
  std::vector<std::string> overrides;  ///< --set, for a study
  std::string length_unit;             ///< for files that do not say it; "" is m
};

/// Metres that one unit of the file measures.
/// @throws Error invalid_argument for a text that is no length
double length_unit(const InputFile& input);

/// Its model, in m, connected; and the results if it has any.
struct LoadedInput {
  geometry::MultiPatch model;
  std::optional<iga::StoredResult> result;
  std::string title;                       ///< of the study; otherwise the file's name
  std::vector<FaceSelection> held = {};    ///< faces of the study's supports
  std::vector<FaceSelection> loaded = {};  ///< and of its loads
};

/// @throws Error as the readers and `connect` do; invalid_argument for a length unit that is none
LoadedInput load_input(const InputFile& input);

}  // namespace isopatch::app
