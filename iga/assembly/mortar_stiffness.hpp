#pragma once

#include <vector>

#include "iga/assembly/mortar_constraints.hpp"
#include "iga/assembly/node_blocks.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// Springs against what mortar constraints forbid and against nothing else, as blocks beside the stiffness:
/// with the jumps j of displacements u, one per row of the constraints, and the rows' sizes s the sum of
/// t s j(u) j(v). So displacements that satisfy the constraints have no energy in them, and a multigrid of
/// the stiffness with these springs is a preconditioner among such displacements. t is some times what
/// Nitsche's method takes as penalty, the mean over each slave's face: the weight of rows makes no difference
/// but to the number of iterations.
///
/// @param spaces      of all patches: of a coarser level the jumps are those of its own multipliers
/// @param same_point  how far faces may be apart, m
/// @return  empty where no face has multipliers
/// @cost    that of `mortar_constraints`, and of the square of (4 degree + 2)^2 nodes for each row
NodeBlocks mortar_stiffness(const MortarTies& ties, const std::vector<PatchSpace>& spaces,
                            const std::vector<Material>& materials, double same_point);

}  // namespace isopatch::iga
