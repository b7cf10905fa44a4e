#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/coupling/row_numbering.hpp"
#include "iga/problem/springs.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// What springs add to the stiffness: the integral over their faces of N_a N_b times their stiffness, the
/// weighted sum of it over the Greville points of holds, or its sum over single points, for any spaces on the
/// patches and parts of them.
///
/// Blocks of pairs of nodes, sparse: only nodes whose functions reach the springs have any.
class SupportStiffness {
 public:
  SupportStiffness() = default;
  /// @param spaces  of all patches; degree + 6 Gauss points per element and direction of the face, as loads
  /// @param parts   what this process integrates: faces along direction 3 and points are shared layer by
  /// layer,
  ///                so the shares of all processes add up
  /// @cost   (degree + 6)^2 (degree + 1)^4 per element of the faces, (degree + 1)^6 per point inside
  SupportStiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                   const Springs& springs);

  bool is_empty() const { return blocks_.empty(); }
  /// forces += S displacement, per node of all patches. (3, nodes)
  void add_forces(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& forces) const;
  /// The diagonal blocks, added per node.
  void add_diagonal(std::vector<Eigen::Matrix3d>& of_nodes) const;
  /// Adds the blocks to a matrix that `assemble_stiffness` made of the same spaces and parts.
  void add_to(solvers::SymmetricBlockMatrix& matrix, const RowNumbering& numbering) const;

 private:
  struct Block {
    int first = 0;  // node, not behind the second
    int second = 0;
    Eigen::Matrix3d value;  // symmetric
  };
  class Sums;
  std::vector<Block> blocks_;  // by nodes
};

}  // namespace isopatch::iga
