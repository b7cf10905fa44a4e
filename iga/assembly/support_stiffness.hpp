#pragma once

#include <vector>

#include "iga/assembly/node_blocks.hpp"
#include "iga/problem/springs.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// What springs add to the stiffness: the integral over their faces of N_a N_b times their stiffness, the
/// weighted sum of it over the Greville points of holds, or its sum over single points, for any spaces on the
/// patches and parts of them.
/// @param spaces  of all patches; degree + 6 Gauss points per element and direction of the face, as loads
/// @param parts   what this process integrates: faces along direction 3 and points are shared layer by layer,
///                so the shares of all processes add up
/// @cost   (degree + 6)^2 (degree + 1)^4 per element of the faces, (degree + 1)^6 per point inside
NodeBlocks support_stiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                             const Springs& springs);

}  // namespace isopatch::iga
