#include "iga/stiffness_pattern.hpp"

#include <algorithm>
#include <numeric>

#include "iga/internal/parallel_for.hpp"
#include "iga/internal/row_graph.hpp"

namespace isopatch::iga {
namespace {

constexpr int rows_per_task = 256;

int task_count(int rows) {
  return (rows + rows_per_task - 1) / rows_per_task;
}

}  // namespace

solvers::SymmetricBlockMatrix stiffness_pattern(const std::vector<PatchSpace>& spaces,
                                                const std::vector<PatchPart>& parts,
                                                const RowNumbering& numbering) {
  const RowGraph graph(spaces, parts, numbering);
  const int rows = graph.rows();
  solvers::SymmetricBlockMatrix matrix;
  matrix.row_start.resize(static_cast<std::size_t>(rows) + 1);
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(task_count(rows)));
  parallel_for(task_count(rows), [&](std::int64_t task, int) {
    std::vector<int>& found = columns[static_cast<std::size_t>(task)];
    std::vector<RowInterval> intervals;
    const int first = static_cast<int>(task) * rows_per_task;
    const int last = std::min(rows, first + rows_per_task);
    for (int row = first; row < last; ++row) {
      graph.neighbours(row, row, intervals);
      std::int64_t count = 0;
      for (const RowInterval& interval : intervals) {
        const std::size_t size = found.size();
        found.resize(size + static_cast<std::size_t>(interval.end - interval.begin));
        std::iota(found.begin() + static_cast<std::ptrdiff_t>(size), found.end(), interval.begin);
        count += interval.end - interval.begin;
      }
      matrix.row_start[static_cast<std::size_t>(row) + 1] = count;
    }
  });
  for (std::size_t r = 1; r < matrix.row_start.size(); ++r) matrix.row_start[r] += matrix.row_start[r - 1];
  matrix.columns.resize(static_cast<std::size_t>(matrix.row_start.back()));
  parallel_for(task_count(rows), [&](std::int64_t task, int) {
    std::vector<int>& found = columns[static_cast<std::size_t>(task)];
    std::copy(found.begin(), found.end(),
              matrix.columns.begin() + matrix.row_start[static_cast<std::size_t>(task * rows_per_task)]);
    std::vector<int>().swap(found);
  });
  matrix.values = solvers::ZeroedVector<double>(9 * matrix.columns.size());
  return matrix;
}

StiffnessSize stiffness_size(const std::vector<PatchSpace>& spaces, const std::vector<PatchPart>& parts,
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
