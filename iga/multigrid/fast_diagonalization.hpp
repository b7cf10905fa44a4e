#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "iga/material/material.hpp"
#include "iga/multigrid/held_faces.hpp"
#include "iga/multigrid/interface_block.hpp"
#include "iga/multigrid/level.hpp"
#include "iga/multigrid/tensor_blocks.hpp"

namespace isopatch::iga {

/// The patch-wise smoother of the multigrid: an approximate inverse of the stiffness of one level.
///
/// In each block of `tensor_blocks`, and for each coordinate component by itself, the stiffness is replaced
/// by a sum of tensor products, K x M x M + M x K x M + M x M x K with coefficients averaged over the patch,
/// which the eigenvectors of the one-dimensional pairs (K, M) diagonalize at once. Scaling from both sides
/// gives it the diagonal of the true stiffness. So it is exact for a box of one material but for the coupling
/// of components and blocks, and its quality does not depend on the degree or the elements' size.
///
/// @source  Lynch, Rice, Thomas 1964 (fast diagonalization); Sangalli, Tani, SIAM J. Sci. Comput. 38 (2016)
class FastDiagonalization {
 public:
  /// @param diagonal  of every local row, the 3 x 3 diagonal block of the stiffness in coordinate axes,
  /// summed
  ///                  over processes
  /// @param surfaces  what the stiffness has beside that of the elements; of faces that do not match all
  ///                  nodes are one block, which is factorized (`InterfaceBlock`)
  /// @param holds     the stiff springs among these, as they are on this level: a block for each patch's
  ///                  (`HeldFaces`)
  /// @cost  O(n^3) per direction with n functions
  FastDiagonalization(const geometry::MultiPatch& model, const Level& level,
                      const std::vector<Material>& materials, const std::vector<Eigen::Matrix3d>& diagonal,
                      const NodeBlocks& surfaces, const Springs& holds = {});

  /// Between consistent local vectors of unknowns. (3 rows)
  /// @cost  12 n flops per unknown with n functions per direction, as matrix products
  Eigen::VectorXd apply(const Eigen::VectorXd& residual) const;

  std::int64_t bytes() const;

 private:
  struct Component {
    std::array<std::shared_ptr<const Eigen::MatrixXd>, 3> modes;  // (functions, modes) per direction
    Eigen::VectorXd inverse;                                      // 1 / eigenvalue per tensor mode
    Eigen::VectorXd scale;                                        // per node
  };
  struct Block {
    std::array<int, 3> sizes;
    std::vector<int> rows;
    std::array<Component, 3> components;
  };
  struct Point {
    int row = 0;
    Eigen::Matrix3d inverse;
  };
  void solve_component(const Block& block, int component, const Eigen::VectorXd& residual,
                       Eigen::VectorXd& result) const;

  const Level* level_;
  std::vector<Block> blocks_;
  std::vector<Point> points_;
  InterfaceBlock interface_;
  HeldFaces held_;
};

}  // namespace isopatch::iga
