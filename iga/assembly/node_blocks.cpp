#include "iga/assembly/node_blocks.hpp"

#include <algorithm>
#include <utility>

namespace isopatch::iga {
namespace {

using RowMajorBlock = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Place = std::pair<int, int>;  // row and column, on or above the diagonal

// Where a block is among those of a matrix; -1 if it has none.
std::int64_t position(const solvers::SymmetricBlockMatrix& matrix, const Place& place) {
  const auto row = static_cast<std::size_t>(place.first);
  const auto begin = matrix.columns.begin() + matrix.row_start[row];
  const auto end = matrix.columns.begin() + matrix.row_start[row + 1];
  const auto found = std::lower_bound(begin, end, place.second);
  return found == end || *found != place.second ? -1 : found - matrix.columns.begin();
}

// The same matrix with more blocks, all 0.
// @param more  places that the matrix has not, increasing, each once
solvers::SymmetricBlockMatrix with_blocks(const solvers::SymmetricBlockMatrix& matrix,
                                          const std::vector<Place>& more) {
  solvers::SymmetricBlockMatrix result;
  const std::size_t blocks = matrix.columns.size() + more.size();
  result.columns.resize(blocks);
  result.values.resize(9 * blocks);
  std::size_t at = 0;
  auto next = more.begin();
  for (int row = 0; row < matrix.block_rows(); ++row) {
    std::int64_t old = matrix.row_start[static_cast<std::size_t>(row)];
    const std::int64_t end = matrix.row_start[static_cast<std::size_t>(row) + 1];
    const auto is_new_next = [&] {
      return next != more.end() && next->first == row &&
             (old == end || next->second < matrix.columns[static_cast<std::size_t>(old)]);
    };
    while (old < end || is_new_next()) {
      if (is_new_next()) {
        result.columns[at++] = (next++)->second;
        continue;
      }
      result.columns[at] = matrix.columns[static_cast<std::size_t>(old)];
      std::copy_n(matrix.values.begin() + 9 * old, 9,
                  result.values.begin() + 9 * static_cast<std::int64_t>(at));
      ++old;
      ++at;
    }
    result.row_start.push_back(static_cast<std::int64_t>(at));
  }
  return result;
}

}  // namespace

void NodeBlocks::add(int first, int second, const Eigen::Matrix3d& value) {
  if (first <= second)
    blocks_.push_back({first, second, value});
  else
    blocks_.push_back({second, first, value.transpose()});
}

void NodeBlocks::add(NodeBlocks other) {
  if (blocks_.capacity() == 0)
    blocks_ = std::move(other.blocks_);
  else
    blocks_.insert(blocks_.end(), other.blocks_.begin(), other.blocks_.end());
}

void BlockSums::add(int first, int second, const Eigen::Matrix3d& value) {
  const bool exchanged = second < first;
  if (exchanged) std::swap(first, second);
  const std::int64_t key = (std::int64_t{first} << 32) | second;
  const auto [at, is_new] = place_.try_emplace(key, keys_.size());
  if (is_new) {
    keys_.push_back(key);
    values_.emplace_back(Eigen::Matrix3d::Zero());
  }
  if (exchanged)
    values_[at->second] += value.transpose();
  else
    values_[at->second] += value;
}

NodeBlocks BlockSums::blocks() const {
  NodeBlocks result;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    result.add(static_cast<int>(keys_[i] >> 32), static_cast<int>(keys_[i] & 0xffffffff), values_[i]);
  return result;
}

void NodeBlocks::add_forces(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& forces) const {
  for (const Block& block : blocks_) {
    forces.col(block.first) += block.value * displacement.col(block.second);
    if (block.first != block.second)
      forces.col(block.second) += block.value.transpose() * displacement.col(block.first);
  }
}

void NodeBlocks::add_diagonal(std::vector<Eigen::Matrix3d>& of_nodes) const {
  for (const Block& block : blocks_)
    if (block.first == block.second) of_nodes[static_cast<std::size_t>(block.first)] += block.value;
}

void NodeBlocks::add_to(solvers::SymmetricBlockMatrix& matrix, const RowNumbering& numbering) const {
  const auto row = [&](int node) { return numbering.row_of_node[static_cast<std::size_t>(node)]; };
  std::vector<Place> missing;
  for (const Block& block : blocks_) {
    const Place place = std::minmax(row(block.first), row(block.second));
    if (place.first < 0) continue;
    if (position(matrix, place) < 0) missing.push_back(place);
  }
  if (!missing.empty()) {
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    matrix = with_blocks(matrix, missing);
  }
  for (const Block& block : blocks_) {
    const int first = row(block.first), second = row(block.second);
    if (first < 0 || second < 0) continue;
    const std::int64_t at = position(matrix, std::minmax(first, second));
    Eigen::Map<RowMajorBlock> entry(&matrix.values[static_cast<std::size_t>(9 * at)]);
    if (first <= second) entry += block.value;
    if (second < first || (first == second && block.first != block.second)) entry += block.value.transpose();
  }
}

}  // namespace isopatch::iga
