#pragma once

#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/assembly/node_blocks.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// The stiffness between the functions of a patch that are not 0 on some of its sides, N/m, with degree + 1
/// Gauss points per element and direction: a principal block of the patch's stiffness, for smoothers.
/// @param sides       each once
/// @param first_node  of the patch, among those of all patches
/// @cost  (degree + 1)^7 for each element on a side
NodeBlocks face_stiffness(const PatchSpace& space, const std::vector<geometry::Side>& sides, int first_node,
                          const Material& material);

}  // namespace isopatch::iga
