#pragma once

#include <vector>

#include "iga/assembly/stiffness_pattern.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/discretization.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// The consistent mass matrix, kg: m I in the block of two rows, with m the integral of density times both
/// functions; blocks as in the stiffness matrix.
/// @param materials  one per patch, with densities
/// @param points     Gauss points per element and direction; 0: as many as each map needs
/// @cost  element by element, in parallel: (p + 1)^9 flops each, and one search per pair of functions
solvers::SymmetricBlockMatrix assemble_mass(const Discretization& discretization,
                                            const std::vector<Material>& materials,
                                            const RowNumbering& numbering, int points = 0);

}  // namespace isopatch::iga
