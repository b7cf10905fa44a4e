#pragma once

#include <array>
#include <vector>

#include "iga/multigrid/level.hpp"

namespace isopatch::iga {

/// A box of nodes low .. high - 1 of one patch.
struct TensorBlock {
  int patch = 0;
  std::array<int, 3> low = {0, 0, 0};
  std::array<int, 3> high = {0, 0, 0};

  std::array<int, 3> sizes() const { return {high[0] - low[0], high[1] - low[1], high[2] - low[2]}; }
  int size() const { return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]); }
};

/// The nodes of one block, first direction fastest.
std::vector<int> nodes_of(const Level& level, const TensorBlock& block);

/// Partitions the global nodes into tensor-product blocks without overlap: the inside of every patch
/// together with its outer faces, the inside of every interface, and of every edge where interfaces meet.
///
/// Nodes that fit into no such block are left out: corners, collapsed edges, edges whose nodes two
/// interfaces number differently, those of faces that do not match, and what other blocks have.
/// @param apart  faces whose nodes have blocks of their own
/// @param taken  per global row: whether it has a block; those of the result are added
std::vector<TensorBlock> tensor_blocks(const geometry::MultiPatch& model, const Level& level,
                                       const std::vector<geometry::PatchFace>& apart,
                                       std::vector<char>& taken);

}  // namespace isopatch::iga
