#pragma once

#include "iga/assembly/internal/patch_side.hpp"
#include "iga/assembly/node_blocks.hpp"
#include "iga/material/material.hpp"

namespace isopatch::iga {

/// What `interface_stiffness` adds for one interface, whatever its sides' parameters, cell by cell of their
/// common refinement.
/// @param own        the traction's side
/// @param penalties  what A is multiplied by in T on each of its elements, 1/m
/// @param points     Gauss points of a cell per direction
/// @cost    (degree + 1)^5 per quadrature point
NodeBlocks cell_stiffness(const PatchSide& own, const PatchSide& other, const Eigen::MatrixXd& penalties,
                          const Material& material, int points, double same_point);

}  // namespace isopatch::iga
