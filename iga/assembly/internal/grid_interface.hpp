#pragma once

#include "geometry/shared_grid.hpp"
#include "iga/assembly/internal/side_grid.hpp"
#include "iga/assembly/node_blocks.hpp"
#include "iga/material/material.hpp"

namespace isopatch::iga {

/// What `interface_stiffness` adds for one interface whose sides have the same lines of equal parameters, by
/// sum factorization.
/// @param own        the traction's side
/// @param penalties  what A is multiplied by in T, on each of its elements, 1/m
/// @cost  about 40 (degree + 1)^3 flops per pair of nodes, a tenth of that where the interface is plane
NodeBlocks grid_stiffness(const SideFunctions& own, const SideFunctions& other,
                          const geometry::SharedGrid& grid, const Eigen::MatrixXd& penalties,
                          const Material& material);

}  // namespace isopatch::iga
