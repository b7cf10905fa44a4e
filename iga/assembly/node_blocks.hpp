#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "iga/coupling/row_numbering.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// A sparse symmetric matrix of 3 x 3 blocks between nodes, beside the stiffness of the elements: what
/// springs and non-matching interfaces add to it.
class NodeBlocks {
 public:
  /// Adds to the block of two nodes, and its transpose to that of the two exchanged. Blocks of the same nodes
  /// are kept side by side: `BlockSums` is for those that come often.
  /// @param value  for first == second symmetric
  void add(int first, int second, const Eigen::Matrix3d& value);
  void add(NodeBlocks other);
  /// Makes room for so many blocks more.
  void reserve(std::size_t more) { blocks_.reserve(blocks_.size() + more); }
  std::size_t size() const { return blocks_.size(); }

  /// forces += S displacement, per node of all patches. (3, nodes)
  void add_forces(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& forces) const;
  /// The diagonal blocks, added per node.
  void add_diagonal(std::vector<Eigen::Matrix3d>& of_nodes) const;
  /// Adds the blocks to a matrix of the same nodes' rows. Blocks that it has not are put in, at the cost of a
  /// copy of the matrix; blocks of nodes without a row are left out.
  void add_to(solvers::SymmetricBlockMatrix& matrix, const RowNumbering& numbering) const;

 private:
  struct Block {
    int first = 0;  // node, not behind the second
    int second = 0;
    Eigen::Matrix3d value;
  };
  std::vector<Block> blocks_;  // in the order in which they came, so that sums are the same in every run
};

/// Sums of blocks that come many times each, element by element.
class BlockSums {
 public:
  /// As `NodeBlocks::add`.
  void add(int first, int second, const Eigen::Matrix3d& value);
  /// Every block once, in the order in which they first came.
  NodeBlocks blocks() const;

 private:
  std::vector<std::int64_t> keys_;
  std::vector<Eigen::Matrix3d> values_;
  std::unordered_map<std::int64_t, std::size_t> place_;
};

}  // namespace isopatch::iga
