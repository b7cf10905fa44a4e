#include "iga/assembly/stiffness_pattern.hpp"

#include <algorithm>
#include <numeric>

#include "iga/assembly/internal/row_graph.hpp"
#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {
namespace {

constexpr int rows_per_task = 256;

int task_count(int rows) {
  return (rows + rows_per_task - 1) / rows_per_task;
}

// Touches every huge page, so that the system clears them in parallel. Left to assembly, threads would often
// come to a new page together, and one wait while it is cleared for the other.
void make_pages(solvers::ZeroedVector<double>& values) {
  constexpr std::int64_t page = (std::int64_t{2} << 20) / static_cast<std::int64_t>(sizeof(double));
  const auto pages = (static_cast<std::int64_t>(values.size()) + page - 1) / page;
  parallel_ranges(pages, [&](std::int64_t i, int) { values[static_cast<std::size_t>(page * i)] = 0; });
}

}  // namespace

solvers::SymmetricBlockMatrix stiffness_pattern(const std::vector<PatchSpace>& spaces,
                                                const std::vector<PatchLayers>& parts,
                                                const RowNumbering& numbering) {
  const RowGraph graph(spaces, parts, numbering);
  const int rows = graph.rows();
  solvers::SymmetricBlockMatrix matrix;
  matrix.row_start.resize(static_cast<std::size_t>(rows) + 1);
  // Intervals first: far fewer numbers than columns, which then go straight to where they stay.
  std::vector<std::vector<RowInterval>> found(static_cast<std::size_t>(task_count(rows)));
  parallel_for(task_count(rows), [&](std::int64_t task, int) {
    std::vector<RowInterval>& intervals = found[static_cast<std::size_t>(task)];
    std::vector<RowInterval> of_row;
    const int first = static_cast<int>(task) * rows_per_task;
    const int last = std::min(rows, first + rows_per_task);
    for (int row = first; row < last; ++row) {
      graph.neighbours(row, row, of_row);
      if (row == first) intervals.reserve(of_row.size() * rows_per_task);
      intervals.insert(intervals.end(), of_row.begin(), of_row.end());
      matrix.row_start[static_cast<std::size_t>(row) + 1] =
          std::accumulate(of_row.begin(), of_row.end(), std::int64_t{0},
                          [](std::int64_t sum, const RowInterval& i) { return sum + i.end - i.begin; });
    }
  });

  std::partial_sum(matrix.row_start.begin(), matrix.row_start.end(), matrix.row_start.begin());
  matrix.columns.resize(static_cast<std::size_t>(matrix.row_start.back()));

  parallel_for(task_count(rows), [&](std::int64_t task, int) {
    int* column = matrix.columns.data() + matrix.row_start[static_cast<std::size_t>(task * rows_per_task)];
    for (const RowInterval& interval : found[static_cast<std::size_t>(task)]) {
      std::iota(column, column + (interval.end - interval.begin), interval.begin);
      column += interval.end - interval.begin;
    }
  });
  matrix.values = solvers::ZeroedVector<double>(9 * matrix.columns.size());
  make_pages(matrix.values);
  return matrix;
}

StiffnessSize stiffness_size(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                             const RowNumbering& numbering) {
  const RowGraph graph(spaces, parts, numbering);
  const int rows = graph.rows();
  std::vector<std::int64_t> counts(static_cast<std::size_t>(task_count(rows)));
  parallel_for(task_count(rows), [&](std::int64_t task, int) {
    std::vector<RowInterval> scratch;
    const int first = static_cast<int>(task) * rows_per_task;
    const int last = std::min(rows, first + rows_per_task);
    for (int row = first; row < last; ++row)
      counts[static_cast<std::size_t>(task)] += graph.neighbour_count(row, scratch);
  });
  // Both of a pair of different rows count the other, but one block of theirs is stored.
  const std::int64_t pairs = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  StiffnessSize size;
  size.blocks = (pairs + rows) / 2;
  size.bytes = size.blocks * static_cast<std::int64_t>(9 * sizeof(double) + sizeof(int)) +
               static_cast<std::int64_t>(sizeof(std::int64_t)) * (rows + 1);
  return size;
}

}  // namespace isopatch::iga
