#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/discretization.hpp"
#include "iga/material.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// Which block row of a matrix belongs to each node; nodes may share a row.
struct RowNumbering {
  std::vector<int> row_of_node;
  int rows = 0;
};

/// The blocks that the supports of basis functions make nonzero, all values 0.
/// @cost  O(blocks log blocks per row)
solvers::SymmetricBlockMatrix stiffness_pattern(const Discretization& discretization,
                                                const RowNumbering& numbering);

/// Stiffness matrix of isotropic elasticity, N/m.
///
/// Element by element: the products of all physical gradients as one symmetric matrix product, integrated
/// with `points` Gauss points per element and direction (0: degree + 1), then added row by row. The sums run
/// in the same order for any number of threads, so the result does not depend on it.
///
/// @throws Error fold_over  a Gauss point with det J <= 0, naming patch, parameter (the input's names) and
/// place
/// @cost   9 n^2 q flops per element of n functions and q points; (p + 1)^9 for degree p
solvers::SymmetricBlockMatrix assemble_stiffness(const Discretization& discretization,
                                                 const std::vector<Material>& materials,
                                                 const RowNumbering& numbering, int points = 0,
                                                 const Progress& progress = {});

}  // namespace isopatch::iga
