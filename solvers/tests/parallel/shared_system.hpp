#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "solvers/linear_system.hpp"

namespace isopatch::solvers {

/// Spreads a number of rows over processes in overlapping stretches, so that `reach` rows on either side of a
/// cut are shared.
inline std::vector<std::vector<int>> overlapping(int rows, int processes, int reach) {
  std::vector<std::vector<int>> result(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row)
    for (int p = 0; p < processes; ++p)
      if (row >= rows * p / processes - reach && row < rows * (p + 1) / processes + reach)
        result[static_cast<std::size_t>(row)].push_back(p);
  return result;
}

inline std::vector<int> common(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// This process' share of a system that every process has whole: each block is spread evenly over the
/// processes that have both of its rows, each constraint belongs to the owner of its first entry.
inline LinearSystem share_of(const LinearSystem& whole, const std::vector<std::vector<int>>& processes_of_row,
                             const Processes& processes) {
  LinearSystem share;
  share.rows = SharedRows(processes_of_row, processes);
  std::vector<int> local(processes_of_row.size(), -1);
  for (int row = 0; row < share.rows.local_rows(); ++row)
    local[static_cast<std::size_t>(share.rows.global_of_local()[static_cast<std::size_t>(row)])] = row;
  share.load = share.rows.part(whole.load);
  for (const int row : share.rows.global_of_local()) {
    for (std::int64_t k = whole.stiffness.row_start[row]; k < whole.stiffness.row_start[row + 1]; ++k) {
      const int column = whole.stiffness.columns[k];
      if (local[column] < 0) continue;
      const auto sharing = common(processes_of_row[row], processes_of_row[column]);
      share.stiffness.columns.push_back(local[column]);
      for (int i = 0; i < 9; ++i)
        share.stiffness.values.push_back(whole.stiffness.values[9 * k + i] / double(sharing.size()));
    }
    share.stiffness.row_start.push_back(share.stiffness.blocks());
  }
  // A constraint is kept by the processes that own its entries, as the multipliers between patches are.
  std::vector<std::vector<int>> of_multiplier;
  std::vector<Eigen::Triplet<double>> entries;
  int kept = 0;
  for (Eigen::Index m = 0; m < whole.constraints.rows(); ++m) {
    std::vector<int> keepers;
    for (ConstraintMatrix::InnerIterator it(whole.constraints, m); it; ++it) {
      const auto row = static_cast<std::size_t>(it.col() / 3);
      keepers.push_back(processes_of_row[row].front());
      if (keepers.back() == processes.rank())
        entries.emplace_back(kept, 3 * local[row] + static_cast<int>(it.col() % 3), it.value());
    }
    std::sort(keepers.begin(), keepers.end());
    keepers.erase(std::unique(keepers.begin(), keepers.end()), keepers.end());
    if (std::binary_search(keepers.begin(), keepers.end(), processes.rank())) ++kept;
    of_multiplier.push_back(std::move(keepers));
  }
  share.multiplier_rows = SharedRows(of_multiplier, processes, 1);
  share.constraints.resize(kept, share.stiffness.rows());
  share.constraints.setFromTriplets(entries.begin(), entries.end());
  return share;
}

}  // namespace isopatch::solvers
