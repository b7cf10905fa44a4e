#pragma once

#include <map>
#include <vector>

#include "iga/assembly/node_blocks.hpp"
#include "iga/material/material.hpp"
#include "iga/multigrid/level.hpp"
#include "solvers/block_matrix.hpp"
#include "solvers/linear_operator.hpp"

namespace isopatch::iga {

/// Some sides of some patches.
using SidesOfPatches = std::map<PatchId, std::vector<geometry::Side>>;

/// The rows of a level that the nodes of some sides have, increasing.
std::vector<int> rows_on(const Level& level, const SidesOfPatches& sides);

/// The stiffness between some rows of a level, supports brought in.
/// @param sides     of patches that this process has: what their elements give
/// @param rows      of nodes of the sides
/// @param surfaces  what the level has beside the elements' stiffness
/// @param diagonal  of every row of the level: what elements elsewhere add is taken from it
/// @cost  that of `face_stiffness`
solvers::SymmetricBlockMatrix side_matrix(const Level& level, const SidesOfPatches& sides,
                                          const std::vector<int>& rows,
                                          const std::vector<Material>& materials, const NodeBlocks& surfaces,
                                          const std::vector<Eigen::Matrix3d>& diagonal);

/// The inverse, with a heavier diagonal where on coarse and strongly curved elements integration leaves the
/// matrix indefinite: a smoother need not be exact.
/// @throws Error singular_system  where ten times the diagonal does not help
solvers::LinearOperator inverse_for_smoothing(const solvers::SymmetricBlockMatrix& matrix);

/// result += inverse residual at some block rows.
void add_to_rows(const std::vector<int>& rows, const solvers::LinearOperator& inverse,
                 const Eigen::VectorXd& residual, Eigen::VectorXd& result);

}  // namespace isopatch::iga
