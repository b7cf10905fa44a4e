#pragma once

#include <optional>

#include "app/study/stage.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/reconstruction/reconstruction_options.hpp"

namespace isopatch::app {

/// Solids to be made patches: files and how.
struct BlocksInput {
  segmentation::BlockFiles files;
  /// How solids are taken apart that are no topological hexahedra; nothing: such solids are refused.
  std::optional<segmentation::DecompositionOptions> decomposition = {};
  segmentation::ParameterizationOptions options;
  /// Whether the fit's tolerance was asked for; otherwise it is no finer than what triangles tell.
  bool gives_tolerance = false;
  segmentation::ReconstructionOptions reconstruction = {};  ///< of files of triangles
  StageTexts texts = {};
  StageOptions stages = {};
  bool operator==(const BlocksInput&) const = default;
};

}  // namespace isopatch::app
