#pragma once

#include <vector>

#include "solvers/block_matrix.hpp"

namespace isopatch::solvers {

/// An elimination order of block rows.
struct BlockOrdering {
  std::vector<int> order;     ///< order[k] is the block row eliminated as the k-th
  std::vector<int> position;  ///< its inverse
};

/// Finds an order with little fill: the better of METIS nested dissection and AMD, by the fill that each
/// predicts, in a postorder of its elimination tree.
///
/// The graph of blocks has a ninth of the scalar graph's edges and the same structure.
///
/// @throws Error unsupported    for more than 2^31 - 1 blocks
/// @throws Error out_of_memory
/// @source Karypis, Kumar 1998 (METIS); Amestoy, Davis, Duff 1996 (AMD); both through CHOLMOD
BlockOrdering fill_reducing_ordering(const SymmetricBlockMatrix& matrix);

}  // namespace isopatch::solvers
