#pragma once

#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/assembly/stiffness_pattern.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/discretization.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// Stiffness matrix of isotropic elasticity, N/m, integrated over the elements of `parts`.
///
/// Patch by patch with sum factorization: the integrals are contracted with the functions' values one
/// direction after the other, for the functions of a whole line at a time, and only for pairs of which the
/// second does not come before the first in direction 3. Nothing is computed for single elements but the
/// geometry at the Gauss points. The sums run in the same order for any number of threads, so the result does
/// not depend on it.
///
/// @param materials  one per space
/// @param points     Gauss points per element and direction; 0: the functions' degree + 1 in each
/// @throws Error fold_over         a Gauss point with det J <= 0, naming patch, parameter (the input's names)
/// and
///                                 place
/// @throws Error invalid_argument  as stiffness_pattern
/// @cost   per node of degree p 81 (p+1)^4 (p+2) + 162 (p+1)^5 + 72 (p+1)^4 (2p+1) flops: 95, 399 and 1215
///         kflop for p = 2, 3, 4. Besides the matrix the geometry at the points of degree + 1 element layers,
///         72 bytes a point, and the blocks there of pairs whose rows are not in the patch's order
/// @source Bressan, Takacs, Sum factorization techniques in isogeometric analysis, CMAME 2019; the order of
/// the
///         contractions and the symmetry in direction 3 are ours
solvers::SymmetricBlockMatrix assemble_stiffness(const std::vector<PatchSpace>& spaces,
                                                 const std::vector<PatchLayers>& parts,
                                                 const std::vector<Material>& materials,
                                                 const RowNumbering& numbering, int points = 0,
                                                 const Progress& progress = {});

/// The same of the whole solution space.
solvers::SymmetricBlockMatrix assemble_stiffness(const Discretization& discretization,
                                                 const std::vector<Material>& materials,
                                                 const RowNumbering& numbering, int points = 0,
                                                 const Progress& progress = {});
/// The pattern of the whole solution space.
solvers::SymmetricBlockMatrix stiffness_pattern(const Discretization& discretization,
                                                const RowNumbering& numbering);

}  // namespace isopatch::iga
