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
                           const SymmetricBlockMatrix& matrix) {
  task_ = task;
  tables_ = &tables;
  second_begin_ = tables.first[1][static_cast<std::size_t>(task.layer_begin)];
  const int second_end =
      tables.first[1][static_cast<std::size_t>(task.layer_end - 1)] + tables.degrees[1] + 1;
  seconds_ = second_end - second_begin_;
  thirds_ = tables.overlap(2, task.third).high - task.third + 1;
  width_second_ = widest(tables.overlaps[1]);
  width_first_ = widest(tables.overlaps[0]);
  targets_.resize(static_cast<std::size_t>(task.first_end - task.first_begin) *
                  static_cast<std::size_t>(seconds_ * thirds_ * width_second_ * width_first_));
  pairs_.clear();
  const auto node = [&](int i, int j, int k) { return i + tables.sizes[0] * (j + tables.sizes[1] * k); };
  for (int i = task.first_begin; i < task.first_end; ++i) {
    const Overlap& first = tables.overlap(0, i);
    for (int j = second_begin_; j < second_end; ++j) {
      const Overlap& second = tables.overlap(1, j);
      const int a = node(i, j, task.third);
      std::int32_t guess = 0;
      for (int k = 0; k < thirds_; ++k) {
        for (int l = std::max(second.low, second_begin_); l <= std::min(second.high, second_end - 1); ++l) {
          auto* to = const_cast<std::int32_t*>(line(i, j, l, task.third + k));
          for (int m = first.low; m <= first.high; ++m)
            *to++ = target_of(a, node(m, l, task.third + k), k == 0, rows, matrix, guess);
        }
      }
    }
  }
  collected_.assign(9 * pairs_.size(), 0.0);
}

std::int32_t BlockTargets::target_of(int a, int b, bool comes_twice, const PatchRows& rows,
                                     const SymmetricBlockMatrix& matrix, std::int32_t& guess) {
  const int row_a = rows.row_of_node[a];
  const int row_b = rows.row_of_node[b];
  if (comes_twice && row_a > row_b) return nowhere;
  if (rows.shared[static_cast<std::size_t>(a)] || row_a > row_b) {
    pairs_.push_back({row_a, row_b, !comes_twice});
    return -1 - static_cast<std::int32_t>(pairs_.size());
  }
  const std::int32_t at = position(matrix, row_a, row_b, guess);
  guess = at + 1;
  return at;
}

const std::int32_t* BlockTargets::line(int a_first, int a_second, int b_second, int b_third) const {
  const int second = b_second - tables_->overlap(1, a_second).low;
  const auto row =
      static_cast<std::size_t>(a_first - task_.first_begin) * static_cast<std::size_t>(seconds_) +
      static_cast<std::size_t>(a_second - second_begin_);
  const auto line =
      (row * static_cast<std::size_t>(thirds_) + static_cast<std::size_t>(b_third - task_.third)) *
          static_cast<std::size_t>(width_second_) +
      static_cast<std::size_t>(second);
  return targets_.data() + line * static_cast<std::size_t>(width_first_);
}

void BlockTargets::flush(int share, int shares, SymmetricBlockMatrix& matrix) const {
  std::int32_t guess = 0;
  for (std::size_t n = 0; n < pairs_.size(); ++n) {
    const auto& [row_a, row_b, both] = pairs_[n];
    const int row = std::min(row_a, row_b);
    if (row / 64 % shares != share) continue;
    guess = position(matrix, row, std::max(row_a, row_b), guess);
    const double* const from = &collected_[9 * n];
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
