#pragma once

#include <cstdint>
#include <vector>

#include "iga/coupling/row_numbering.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// The blocks that the supports of basis functions make nonzero on the elements of `parts`, all values 0, and
/// the diagonal blocks of all rows.
/// @throws Error invalid_argument  parts out of range, a node of a part without a row, a row out of range
/// @cost   O(blocks) where the numbering follows the patches, else O(blocks log degree)
solvers::SymmetricBlockMatrix stiffness_pattern(const std::vector<PatchSpace>& spaces,
                                                const std::vector<PatchLayers>& parts,
                                                const RowNumbering& numbering);

/// What a stiffness matrix will take.
struct StiffnessSize {
  std::int64_t blocks = 0;  ///< stored, so on and above the diagonal
  std::int64_t bytes = 0;   ///< of the matrix
};

/// Counts the blocks of `stiffness_pattern` without building it.
///
/// Exact: nodes that have a row of their own have as many neighbours as the supports of their functions in
/// each direction say; the neighbours of others are counted one by one.
///
/// @throws Error as stiffness_pattern
/// @cost   O(nodes), and O((2 degree + 1)^3) per node that shares its row, or whose patch has two nodes in
/// one row
StiffnessSize stiffness_size(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                             const RowNumbering& numbering);

}  // namespace isopatch::iga
