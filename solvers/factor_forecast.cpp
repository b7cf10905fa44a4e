#include "solvers/factor_forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "geometry/base/error.hpp"
#include "solvers/internal/cholmod_api.hpp"

namespace isopatch::solvers {
namespace {

// The lower triangle by columns, diagonal included.
struct LowerTriangle {
  std::vector<int> column_start = {0};
  std::vector<int> rows;
};

LowerTriangle lower_triangle(const RowGroups& groups) {
  LowerTriangle lower;
  for (int g = 0; g < groups.count(); ++g) {
    lower.rows.push_back(g);
    for (int k = groups.edge_start[g]; k < groups.edge_start[g + 1]; ++k)
      if (groups.neighbours[k] > g) lower.rows.push_back(groups.neighbours[k]);
    std::sort(lower.rows.begin() + lower.column_start.back(), lower.rows.end());
    lower.column_start.push_back(static_cast<int>(lower.rows.size()));
  }
  return lower;
}

std::vector<int> elimination_order(const RowGroups& groups, LowerTriangle& lower, int method) {
  CholmodWorkspace<std::int32_t> workspace;
  workspace->nmethods = 1;
  workspace->method[0].ordering = method;
  workspace->postorder = true;
  workspace->supernodal = CHOLMOD_SIMPLICIAL;
  cholmod_sparse graph = lower_triangle_view<std::int32_t>(groups.rows.size(), lower.column_start.data(),
                                                           lower.rows.data(), nullptr, true);
  const CholmodFactor<std::int32_t> factor(cholmod_analyze(&graph, workspace.get()), workspace);
  if (!factor.get())
    throw Error(workspace->status == CHOLMOD_OUT_OF_MEMORY ? ErrorCode::out_of_memory : ErrorCode::internal,
                fmt::format("ordering {} groups of rows failed (CHOLMOD status {})", groups.count(),
                            workspace->status));
  const auto* const order = static_cast<const int*>(factor->Perm);
  return {order, order + groups.count()};
}

// Rows below each group in the factor. Row i of the factor has the groups on the ways from i's neighbours, up
// the elimination tree, to i; the tree grows on the way.
std::vector<double> rows_below(const RowGroups& groups, const std::vector<int>& order) {
  const int n = groups.count();
  std::vector<int> position(n), parent(n, -1), reached(n, -1);
  for (int k = 0; k < n; ++k) position[order[k]] = k;
  std::vector<double> below(n, 0.0);
  for (int i = 0; i < n; ++i) {
    const int group = order[i];
    reached[i] = i;
    for (int e = groups.edge_start[group]; e < groups.edge_start[group + 1]; ++e)
      for (int k = position[groups.neighbours[e]]; k < i && reached[k] != i; k = parent[k]) {
        reached[k] = i;
        below[k] += groups.rows[group];
        if (parent[k] < 0) parent[k] = i;
      }
  }
  return below;
}

FactorForecast counted(const RowGroups& groups, const std::vector<int>& order) {
  const std::vector<double> below = rows_below(groups, order);
  FactorForecast result;
  for (int k = 0; k < groups.count(); ++k) {
    const double w = groups.rows[order[k]], c = below[k];
    // Columns of a group have c + w, ..., c + 1 entries; a column of m entries takes m^2 operations.
    result.entries += w * c + w * (w + 1) / 2;
    result.flops += w * c * c + c * w * (w + 1) + w * (w + 1) * (2 * w + 1) / 6;
    result.largest_front = std::max(result.largest_front, (c + w) * (c + w));
  }
  return result;
}

}  // namespace

FactorForecast forecast_factor(const RowGroups& groups) {
  if (groups.count() == 0) return {};
  LowerTriangle lower = lower_triangle(groups);
  FactorForecast best;
  for (const int method : {CHOLMOD_METIS, CHOLMOD_AMD}) {
    const FactorForecast found = counted(groups, elimination_order(groups, lower, method));
    if (best.flops == 0 || found.flops < best.flops) best = found;
  }
  return best;
}

}  // namespace isopatch::solvers
