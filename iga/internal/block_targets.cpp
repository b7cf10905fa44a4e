#include "iga/internal/block_targets.hpp"

#include <algorithm>
#include <numeric>

namespace isopatch::iga {
namespace {

using solvers::SymmetricBlockMatrix;

// Position of a column in its row, looked for at `guess` first.
std::int32_t position(const SymmetricBlockMatrix& matrix, int row, int column, std::int32_t guess) {
  const std::int64_t begin = matrix.row_start[static_cast<std::size_t>(row)];
  const std::int64_t end = matrix.row_start[static_cast<std::size_t>(row) + 1];
  if (begin + guess < end && matrix.columns[static_cast<std::size_t>(begin + guess)] == column) return guess;
  const auto first = matrix.columns.begin() + begin;
  return static_cast<std::int32_t>(std::lower_bound(first, matrix.columns.begin() + end, column) - first);
}

int widest(const std::vector<Overlap>& overlaps) {
  int width = 0;
  for (const Overlap& overlap : overlaps) width = std::max(width, overlap.count());
  return width;
}

}  // namespace

PatchRows patch_rows(const StiffnessTables& tables, const int* row_of_node) {
  const int plane = tables.sizes[0] * tables.sizes[1];
  std::vector<int> nodes;
  for (int k = 0; k < tables.sizes[2]; ++k) {
    if (tables.overlap(2, k).empty()) continue;
    nodes.resize(nodes.size() + static_cast<std::size_t>(plane));
    std::iota(nodes.end() - plane, nodes.end(), k * plane);
  }
  const auto before = [&](int a, int b) { return row_of_node[a] < row_of_node[b]; };
  if (!std::is_sorted(nodes.begin(), nodes.end(), before)) std::sort(nodes.begin(), nodes.end(), before);
  PatchRows rows{row_of_node, std::vector<char>(static_cast<std::size_t>(plane * tables.sizes[2]), 0)};
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (row_of_node[nodes[i]] == row_of_node[nodes[i - 1]])
      rows.shared[static_cast<std::size_t>(nodes[i])] = rows.shared[static_cast<std::size_t>(nodes[i - 1])] =
          1;
  return rows;
}

void BlockTargets::prepare(const StiffnessTask& task, const StiffnessTables& tables, const PatchRows& rows,
                           const SymmetricBlockMatrix& matrix, CollectedBlocks& collected) {
  task_ = task;
  tables_ = &tables;
  second_begin_ = tables.first[1][static_cast<std::size_t>(task.layer_begin)];
  const int second_end =
      tables.first[1][static_cast<std::size_t>(task.layer_end - 1)] + tables.degrees[1] + 1;
  seconds_ = second_end - second_begin_;
  thirds_ = tables.overlap(2, task.third).high - task.third + 1;
  width_second_ = widest(tables.overlaps[1]);
  width_first_ = widest(tables.overlaps[0]);
  const std::size_t size = static_cast<std::size_t>(task.first_end - task.first_begin) *
                           static_cast<std::size_t>(seconds_ * thirds_ * width_second_ * width_first_);
  if (targets_.size() < size) targets_.resize(size);
  collected.clear();
  const auto node = [&](int i, int j, int k) { return i + tables.sizes[0] * (j + tables.sizes[1] * k); };
  for (int i = task.first_begin; i < task.first_end; ++i) {
    const Overlap& first = tables.overlap(0, i);
    for (int j = second_begin_; j < second_end; ++j) {
      const Overlap& second = tables.overlap(1, j);
      for (int k = task.third; k < task.third + thirds_; ++k)
        for (int l = std::max(second.low, second_begin_); l <= std::min(second.high, second_end - 1); ++l)
          fill(node(i, j, task.third), node(first.low, l, k), first.count(), k == task.third, rows, matrix,
               collected, targets_.data() + line_start(i, j, l, k));
    }
  }
  collected.zero();
}

// The targets of a with b_begin and the nodes behind it.
void BlockTargets::fill(int a, int b_begin, int count, bool comes_twice, const PatchRows& rows,
                        const SymmetricBlockMatrix& matrix, CollectedBlocks& collected,
                        std::int32_t* to) const {
  const int row_a = rows.row_of_node[a];
  const int* const rows_b = rows.row_of_node + b_begin;
  const bool shared = rows.shared[static_cast<std::size_t>(a)] != 0;
  std::int32_t guess = -1;
  for (int m = 0; m < count; ++m) {
    const int row_b = rows_b[m];
    if (comes_twice && row_a > row_b) {
      to[m] = nowhere;
    } else if (shared || row_a > row_b) {
      to[m] = -2 - collected.append(row_a, row_b, !comes_twice);
    } else {
      to[m] = position(matrix, row_a, row_b, guess + 1);
      guess = to[m];
    }
  }
}

std::size_t BlockTargets::line_start(int a_first, int a_second, int b_second, int b_third) const {
  const int second = b_second - tables_->overlap(1, a_second).low;
  const auto row =
      static_cast<std::size_t>((a_first - task_.first_begin) * seconds_ + a_second - second_begin_);
  const auto line =
      (row * static_cast<std::size_t>(thirds_) + static_cast<std::size_t>(b_third - task_.third)) *
          static_cast<std::size_t>(width_second_) +
      static_cast<std::size_t>(second);
  return line * static_cast<std::size_t>(width_first_);
}

void CollectedBlocks::flush(int share, int shares, SymmetricBlockMatrix& matrix) const {
  std::int32_t guess = 0;
  for (std::size_t n = 0; n < pairs_.size(); ++n) {
    const auto& [row_a, row_b, both] = pairs_[n];
    const int row = std::min(row_a, row_b);
    if (row / 64 % shares != share) continue;
    guess = position(matrix, row, std::max(row_a, row_b), guess);
    const double* const from = &values_[9 * n];
    double* const to =
        &matrix
             .values[static_cast<std::size_t>(9 * (matrix.row_start[static_cast<std::size_t>(row)] + guess))];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        if (row_a <= row_b) to[3 * i + j] += from[3 * i + j];
        if (row_a > row_b || (row_a == row_b && both)) to[3 * i + j] += from[3 * j + i];
      }
  }
}

}  // namespace isopatch::iga
