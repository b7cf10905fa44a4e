#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/base/choices.hpp"

namespace isopatch::app {

/// The steps from a file of triangles or solids to a solution, in their order.
enum class Stage {
  solid,      ///< read, or made of triangles
  hexahedra,  ///< what solids are cut into
  patches,    ///< hexahedra fitted with splines
  solution,   ///< of the study
};
/// Called as the enumerators.
const Choices<Stage>& stage_choices();

/// Where results of stages stay between runs, and which of them are taken again.
struct StageOptions {
  std::filesystem::path folder = {};  ///< empty: they are neither kept nor taken
  std::optional<Stage> from = {};     ///< this and those after it are made anew, whatever is kept
  bool writes = true;                 ///< false: kept results are taken, and none is added
  bool operator==(const StageOptions&) const = default;
};

/// Of the results of stages, in the folder of results.
inline constexpr const char* stage_folder_name = "stages";

/// What the study says about stages, as text that does not depend on how the file is laid out.
struct StageTexts {
  std::string model = {};  ///< but for files, attached patches and how patches are put together
  std::string reconstruction = {};
  std::string segmentation = {};
  std::string parameterization = {};
  bool operator==(const StageTexts&) const = default;
};

}  // namespace isopatch::app
