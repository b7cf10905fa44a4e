#pragma once

#include <vector>

#include "geometry/multi_patch.hpp"
#include "segmentation/parameterization/hex_model.hpp"

namespace isopatch::segmentation {

/// Patches in the order of the blocks, with what the model knows of them: names, the interfaces, and the
/// outer faces as boundaries: under the names of the solids' faces, with the block's in front where there are
/// several; then under their colours.
geometry::PatchSet patch_set(const HexModel& model, std::vector<geometry::NurbsVolume> patches);

}  // namespace isopatch::segmentation
