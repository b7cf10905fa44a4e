#pragma once

#include <optional>
#include <vector>

#include "app/problem/reconstructed_solids.hpp"
#include "app/problem/stage_folder.hpp"
#include "app/study/blocks_input.hpp"
#include "geometry/base/progress.hpp"
#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"

namespace isopatch::app {

/// In the folder of stages, of a solid that was made of triangles: the same for other programs.
inline constexpr const char* solid_step_name = "solid.step";

/// What came of solids on their way to patches.
struct StagedPatches {
  /// Nothing where an earlier stage was asked for.
  std::optional<segmentation::Parameterization> made;
  std::vector<StageReport> stages;  ///< in their order; blocks that are given have no solid before them
};

/// Makes solids, hexahedra and patches of files, as far as asked for, or takes what an earlier run kept: a
/// stage is made again if the files, what the study says about it, or the program have changed, or the result
/// of the stage before. Lengths are metres.
/// @param to  the last stage wanted; `Stage::patches` or one before it
/// @throws Error as `read_solids`, `reconstruct`, `decompose`, `hex_model` and `parameterize` do; stages
///     before are kept then
StagedPatches staged_patches(const BlocksInput& input, Stage to, const Progress& progress = {});

}  // namespace isopatch::app
