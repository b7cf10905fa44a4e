#pragma once

#include <vector>

#include "iga/material/material.hpp"
#include "iga/multigrid/level.hpp"
#include "iga/problem/springs.hpp"
#include "solvers/linear_operator.hpp"

namespace isopatch::iga {

/// The smoother's blocks of faces that stiff springs hold: for each patch the inverse of the stiffness
/// between the nodes of its held faces, springs included. Springs hold along directions that turn, which no
/// tensor product follows, and so much more than the part that the nodes of a face move together or hardly at
/// all.
class HeldFaces {
 public:
  HeldFaces() = default;
  /// @param holds     as they are on this level; none: no blocks
  /// @param taken     per global row of the level: those of other blocks; those of these are added on all
  /// processes
  /// @param diagonal  of every local row, the 3 x 3 diagonal block of the stiffness
  /// @cost  a sparse factorization of each patch's held faces, by the process that acts for it
  HeldFaces(const Level& level, const std::vector<Material>& materials, const Springs& holds,
            const std::vector<Eigen::Matrix3d>& diagonal, std::vector<char>& taken);

  /// Adds the blocks' share, additive over processes. Vectors of unknowns, (3 rows).
  void add(const Eigen::VectorXd& residual, Eigen::VectorXd& result) const;

 private:
  struct Block {
    std::vector<int> rows;  // of the level
    solvers::LinearOperator inverse;
  };
  std::vector<Block> blocks_;
};

}  // namespace isopatch::iga
