#include "iga/distribution/shared_multipliers.hpp"

#include <algorithm>

namespace isopatch::iga {
namespace {

std::vector<int> primary_of_nodes(const std::vector<int>& first_node, const Distribution& distribution) {
  const auto of_patch = processes_of_patches(distribution, static_cast<int>(first_node.size()) - 1);
  std::vector<int> primary;
  for (std::size_t p = 0; p < of_patch.size(); ++p)
    primary.insert(primary.end(), static_cast<std::size_t>(first_node[p + 1] - first_node[p]),
                   of_patch[p].front());
  return primary;
}

}  // namespace

SharedMultipliers shared_multipliers(const std::vector<MultiplierRow>& rows, const LocalRows& local,
                                     const std::vector<int>& first_node, const Distribution& distribution) {
  SharedMultipliers result;
  result.matrix = multiplier_matrix(rows, first_node.back());
  const solvers::Processes& processes = local.rows.processes();
  if (processes.count() == 1) return result;
  const std::vector<int> primary = primary_of_nodes(first_node, distribution);
  std::vector<Eigen::Triplet<double>> entries;
  int kept = 0;
  for (const MultiplierRow& row : rows) {
    const int first = primary[static_cast<std::size_t>(row.first)];
    const int second = primary[static_cast<std::size_t>(row.second)];
    const auto column = [&](int node) {
      return 3 * local.numbering.row_of_node[static_cast<std::size_t>(node)] + row.axis;
    };
    if (first == processes.rank()) entries.emplace_back(kept, column(row.first), 1.0);
    if (second == processes.rank()) entries.emplace_back(kept, column(row.second), -1.0);
    if (first == processes.rank() || second == processes.rank()) ++kept;
    result.processes_of_row.push_back(
        first == second ? std::vector<int>{first}
                        : std::vector<int>{std::min(first, second), std::max(first, second)});
  }
  result.matrix.resize(kept, 3 * local.rows.local_rows());
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace isopatch::iga
