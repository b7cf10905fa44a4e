#include "iga/assembly/internal/block_targets.hpp"

#include <algorithm>
#include <numeric>

namespace isopatch::iga {
namespace {

using solvers::SymmetricBlockMatrix;

// Position of a column in its row, looked for at `guess` and beside it first.
std::int32_t position(const SymmetricBlockMatrix& matrix, int row, int column, std::int32_t guess) {
  const std::int64_t begin = matrix.row_start[static_cast<std::size_t>(row)];
  const auto size = static_cast<std::int32_t>(matrix.row_start[static_cast<std::size_t>(row) + 1] - begin);
  const int* const columns = matrix.columns.data() + begin;
  for (const std::int32_t at : {guess, guess - 1, guess + 1})
    if (at >= 0 && at < size && columns[at] == column) return at;
  return static_cast<std::int32_t>(std::lower_bound(columns, columns + size, column) - columns);
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
                           static_cast<std::size_t>(seconds_ * thirds_ * width_second_ * (width_first_ + 1));
  if (targets_.size() < size) targets_.resize(size);
  collected.clear();
  const auto node = [&](int i, int j, int k) { return i + tables.sizes[0] * (j + tables.sizes[1] * k); };
  // A line begins about where the same line of the function before does.
  std::vector<std::int32_t> guesses(static_cast<std::size_t>(seconds_ * thirds_ * width_second_), 0);
  for (int i = task.first_begin; i < task.first_end; ++i) {
    const Overlap& first = tables.overlap(0, i);
    std::int32_t* guess = guesses.data();
    for (int j = second_begin_; j < second_end; ++j) {
      const Overlap& second = tables.overlap(1, j);
      for (int k = task.third; k < task.third + thirds_; ++k)
        for (int l = std::max(second.low, second_begin_); l <= std::min(second.high, second_end - 1);
             ++l, ++guess)
          *guess = fill({node(i, j, task.third), node(first.low, l, k), first.count(), k == task.third},
                        *guess, rows, matrix, collected, targets_.data() + line_start(i, j, l, k));
    }
  }
  collected.zero();
}

// The targets of a line of pairs; returns the position of its first block in a's row, or the guess.
std::int32_t BlockTargets::fill(const Line& line, std::int32_t guess, const PatchRows& rows,
                                const SymmetricBlockMatrix& matrix, CollectedBlocks& collected,
                                std::int32_t* to) const {
  const int row_a = rows.row_of_node[line.a];
  const int* const rows_b = rows.row_of_node + line.b;
  const bool shared = rows.shared[static_cast<std::size_t>(line.a)] != 0;
  to[0] = 0;
  ++to;
  if (!shared && rows_b[0] >= row_a) {
    const std::int64_t begin = matrix.row_start[static_cast<std::size_t>(row_a)];
    const std::int64_t end = matrix.row_start[static_cast<std::size_t>(row_a) + 1];
    const std::int32_t first = position(matrix, row_a, rows_b[0], guess);
    bool in_a_row = begin + first + line.count <= end;
    for (int m = 1; in_a_row && m < line.count; ++m)
      in_a_row = matrix.columns[static_cast<std::size_t>(begin + first + m)] == rows_b[m];
    if (in_a_row) {
      to[-1] = 1;
      to[0] = first;
      return first;
    }
  }
  std::int32_t first = -1;
  for (int m = 0; m < line.count; ++m) {
    const int row_b = rows_b[m];
    if (line.comes_twice && row_a > row_b) {
      to[m] = nowhere;
    } else if (shared || row_a > row_b) {
      to[m] = -2 - collected.append(row_a, row_b, !line.comes_twice);
    } else {
      to[m] = position(matrix, row_a, row_b, guess);
      if (first < 0) first = to[m];
      guess = to[m] + 1;
    }
  }
  return first < 0 ? guess : first;
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
