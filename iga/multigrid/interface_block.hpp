#pragma once

#include <vector>

#include "iga/assembly/node_blocks.hpp"
#include "iga/material/material.hpp"
#include "iga/multigrid/level.hpp"
#include "solvers/block_matrix.hpp"
#include "solvers/linear_operator.hpp"

namespace isopatch::iga {

/// The nodes of all faces that do not match, per node of a level.
std::vector<bool> nodes_that_do_not_match(const geometry::MultiPatch& model, const Level& level);

/// The stiffness between the nodes of all faces that do not match, on both sides, supports brought in.
struct InterfaceMatrix {
  std::vector<int> rows;  ///< of the level, increasing; none where this process ties no faces
  solvers::SymmetricBlockMatrix matrix;
};
/// @param surfaces  what the level has beside the elements' stiffness
/// @param diagonal  of every row: what other elements add to nodes at the faces' edges is taken from it
InterfaceMatrix interface_matrix(const geometry::MultiPatch& model, const Level& level,
                                 const std::vector<Material>& materials, const NodeBlocks& surfaces,
                                 const std::vector<Eigen::Matrix3d>& diagonal);

/// The smoother's block of faces that do not match: the inverse of the stiffness between the nodes on both
/// sides of them, Nitsche's terms included. Penalties tie both sides so much more than they tie either to its
/// patch that blocks of one side alone would hardly move the two together.
class InterfaceBlock {
 public:
  /// The parameters are those of `interface_matrix`.
  /// @cost  a sparse factorization of the faces' nodes
  InterfaceBlock(const geometry::MultiPatch& model, const Level& level,
                 const std::vector<Material>& materials, const NodeBlocks& surfaces,
                 const std::vector<Eigen::Matrix3d>& diagonal);

  /// Adds the block's share; nothing where all faces match. Vectors of unknowns, (3 rows).
  void add(const Eigen::VectorXd& residual, Eigen::VectorXd& result) const;

 private:
  std::vector<int> rows_;  // of the level
  solvers::LinearOperator inverse_;
};

}  // namespace isopatch::iga
