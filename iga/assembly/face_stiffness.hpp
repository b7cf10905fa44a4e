#pragma once

#include "geometry/patch_face.hpp"
#include "iga/assembly/node_blocks.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// The stiffness between the functions of a patch that are not 0 on one of its sides, N/m, with degree + 1
/// Gauss points per element and direction: a block of the whole stiffness, for smoothers.
/// @param first_node  of the patch, among those of all patches
/// @cost  (degree + 1)^7 for each element on the side
NodeBlocks face_stiffness(const PatchSpace& space, geometry::Side side, int first_node,
                          const Material& material);

}  // namespace isopatch::iga
