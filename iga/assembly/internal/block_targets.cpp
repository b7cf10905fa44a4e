#include "iga/assembly/internal/block_targets.hpp"

#include <algorithm>
#include <numeric>

namespace isopatch::iga {
namespace {

using solvers::SymmetricBlockMatrix;

// Position of a column in its row, looked for at `guess` and beside it first.
std::uint32_t position(const SymmetricBlockMatrix& matrix, int row, int column, std::uint32_t guess) {
  const std::int64_t begin = matrix.row_start[static_cast<std::size_t>(row)];
  const auto size = static_cast<std::int32_t>(matrix.row_start[static_cast<std::size_t>(row) + 1] - begin);
  const int* const columns = matrix.columns.data() + begin;
  const auto middle = static_cast<std::int32_t>(guess);
  for (const std::int32_t at : {middle, middle - 1, middle + 1})
    if (at >= 0 && at < size && columns[at] == column) return static_cast<std::uint32_t>(at);
  return static_cast<std::uint32_t>(std::lower_bound(columns, columns + size, column) - columns);
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
  v_begin_ = tables.first[1][static_cast<std::size_t>(task.layer_begin)];
  const int v_end = tables.first[1][static_cast<std::size_t>(task.layer_end - 1)] + tables.degrees[1] + 1;
  count_v_ = v_end - v_begin_;
  count_w_ = tables.overlap(2, task.a_w).high - task.a_w + 1;
  width_v_ = widest(tables.overlaps[1]);
  width_u_ = widest(tables.overlaps[0]);
  const std::size_t size = static_cast<std::size_t>(task.u_end - task.u_begin) *
                           static_cast<std::size_t>(count_v_ * count_w_ * width_v_ * width_u_);
  if (targets_.size() < size) targets_.resize(size);
  collected.clear();
  const auto node = [&](int i, int j, int k) { return i + tables.sizes[0] * (j + tables.sizes[1] * k); };
  // A line begins about where the same line of the function before does.
  std::vector<std::uint32_t> guesses(static_cast<std::size_t>(count_v_ * count_w_ * width_v_), 0);
  for (int i = task.u_begin; i < task.u_end; ++i) {
    const Overlap& u = tables.overlap(0, i);
    std::uint32_t* guess = guesses.data();
    for (int j = v_begin_; j < v_end; ++j) {
      const Overlap& v = tables.overlap(1, j);
      for (int k = task.a_w; k < task.a_w + count_w_; ++k)
        for (int l = std::max(v.low, v_begin_); l <= std::min(v.high, v_end - 1); ++l, ++guess)
          *guess = fill({node(i, j, task.a_w), node(u.low, l, k), u.count(), k == task.a_w}, *guess, rows,
                        matrix, collected, targets_.data() + line_start(i, j, l, k));
    }
  }
  collected.zero();
}

// The targets of a line of pairs; returns the position of its first block in a's row, or the guess.
std::uint32_t BlockTargets::fill(const Line& line, std::uint32_t guess, const PatchRows& rows,
                                 const SymmetricBlockMatrix& matrix, CollectedBlocks& collected,
                                 Target* to) const {
  using Where = Target::Where;
  const int row_a = rows.row_of_node[line.a];
  const int* const rows_b = rows.row_of_node + line.b;
  const bool shared = rows.shared[static_cast<std::size_t>(line.a)] != 0;
  if (!shared && rows_b[0] >= row_a) {
    const std::int64_t begin = matrix.row_start[static_cast<std::size_t>(row_a)];
    const std::int64_t end = matrix.row_start[static_cast<std::size_t>(row_a) + 1];
    const std::uint32_t first = position(matrix, row_a, rows_b[0], guess);
    bool is_run = begin + first + line.count <= end;
    for (int m = 1; is_run && m < line.count; ++m)
      is_run = matrix.columns[static_cast<std::size_t>(begin + first + m)] == rows_b[m];
    if (is_run) {
      to[0] = {Where::run, first};
      return first;
    }
  }
  bool found = false;
  std::uint32_t first = guess;
  for (int m = 0; m < line.count; ++m) {
    const int row_b = rows_b[m];
    if (line.comes_twice && row_a > row_b) {
      to[m] = {Where::nowhere, 0};
    } else if (shared || row_a > row_b) {
      const int number = collected.append(row_a, row_b, !line.comes_twice);
      to[m] = {Where::collected, static_cast<std::uint32_t>(number)};
    } else {
      const std::uint32_t at = position(matrix, row_a, row_b, guess);
      to[m] = {Where::a_row, at};
      if (!found) first = at;
      found = true;
      guess = at + 1;
    }
  }
  return found ? first : guess;
}

void CollectedBlocks::flush(int share, int shares, SymmetricBlockMatrix& matrix) const {
  constexpr int n = solvers::block_size;
  std::uint32_t guess = 0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const auto& [row_a, row_b, both] = pairs_[k];
    const int row = std::min(row_a, row_b);
    if (row / 64 % shares != share) continue;
    guess = position(matrix, row, std::max(row_a, row_b), guess);
    const double* const from = &values_[solvers::block_entries * k];
    const std::int64_t at = matrix.row_start[static_cast<std::size_t>(row)] + guess;
    double* const to = &matrix.values[static_cast<std::size_t>(solvers::block_entries * at)];
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (row_a <= row_b) to[n * i + j] += from[n * i + j];
        if (row_a > row_b || (row_a == row_b && both)) to[n * i + j] += from[n * j + i];
      }
  }
}

}  // namespace isopatch::iga
