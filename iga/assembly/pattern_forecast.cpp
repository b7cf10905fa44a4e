#include "iga/assembly/pattern_forecast.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "iga/assembly/internal/direction_overlap.hpp"
#include "iga/coupling/global_nodes.hpp"

namespace isopatch::iga {
namespace {

// The functions of one direction in groups: how many there are, and which overlap.
struct LineGroups {
  std::vector<int> size;
  // Per group and neighbour low .. high: pairs of functions that overlap, one of each.
  struct Neighbours {
    int low = 0;
    std::vector<std::int64_t> pairs;
  };
  std::vector<Neighbours> neighbours;

  int count() const { return static_cast<int>(size.size()); }
};

// First and last function alone, the others in groups of about `width`; the same from both ends, for
// neighbours may count the other way round.
std::vector<int> group_sizes(int functions, double width) {
  const int inner = functions - 2;
  if (inner <= 0) return std::vector<int>(static_cast<std::size_t>(functions), 1);
  int count = std::clamp(static_cast<int>(std::ceil(inner / width)), 1, inner);
  if (count % 2 == 0 && inner % count % 2 == 1) ++count;
  std::vector<int> sizes(static_cast<std::size_t>(count), inner / count);
  int rest = inner % count;
  if (rest % 2 == 1) ++sizes[static_cast<std::size_t>(count / 2)];
  for (int k = 0; k < rest / 2; ++k) {
    ++sizes[static_cast<std::size_t>(k)];
    ++sizes[static_cast<std::size_t>(count - 1 - k)];
  }
  sizes.insert(sizes.begin(), 1);
  sizes.push_back(1);
  return sizes;
}

LineGroups line_groups(const geometry::KnotVector& knots, double widening) {
  LineGroups result;
  result.size = group_sizes(knots.size(), std::max(1.0, widening * knots.degree()));
  std::vector<int> group_of;
  for (int g = 0; g < result.count(); ++g)
    group_of.insert(group_of.end(), static_cast<std::size_t>(result.size[static_cast<std::size_t>(g)]), g);
  result.neighbours.resize(result.size.size());
  const std::vector<Overlap> overlap = overlaps(knots);
  for (std::size_t i = 0; i < group_of.size(); ++i) {
    LineGroups::Neighbours& of_group = result.neighbours[static_cast<std::size_t>(group_of[i])];
    if (of_group.pairs.empty()) of_group.low = group_of[static_cast<std::size_t>(overlap[i].low)];
    for (int j = overlap[i].low; j <= overlap[i].high; ++j) {
      const auto at = static_cast<std::size_t>(group_of[static_cast<std::size_t>(j)] - of_group.low);
      if (at >= of_group.pairs.size()) of_group.pairs.resize(at + 1, 0);
      ++of_group.pairs[at];
    }
  }
  return result;
}

using PatchGroups = std::array<LineGroups, 3>;

// Groups as wide as functions overlap, or `widening` times that so that there are no more than wanted.
std::vector<PatchGroups> patch_groups(const DirectionKnots& knots, int most_groups, double& widening) {
  std::vector<PatchGroups> patches(knots.size() / 3);
  for (widening = 1;; widening *= 1.25) {
    double total = 0;
    bool can_shrink = false;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      double of_patch = 1;
      for (std::size_t d = 0; d < 3; ++d) {
        const geometry::KnotVector& line = knots[3 * p + d];
        const auto groups = group_sizes(line.size(), std::max(1.0, widening * line.degree())).size();
        can_shrink = can_shrink || groups > 3;
        of_patch *= static_cast<double>(groups);
      }
      total += of_patch;
    }
    if (total > most_groups && can_shrink) continue;
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (std::size_t d = 0; d < 3; ++d) patches[p][d] = line_groups(knots[3 * p + d], widening);
    return patches;
  }
}

// An edge of the graph of groups, once for each patch that has it.
struct GroupPair {
  int first;
  int second;
  std::int64_t pairs;  // of their nodes
};

template <class Visit>
void for_each_cell(const PatchGroups& groups, Visit visit) {
  int cell = 0;
  for (int k = 0; k < groups[2].count(); ++k)
    for (int j = 0; j < groups[1].count(); ++j)
      for (int i = 0; i < groups[0].count(); ++i) visit(std::array{i, j, k}, cell++);
}

int size_of(const PatchGroups& groups, const std::array<int, 3>& at) {
  int result = 1;
  for (std::size_t d = 0; d < 3; ++d) result *= groups[d].size[static_cast<std::size_t>(at[d])];
  return result;
}

// Pairs of groups of a patch that share an element, the second not before the first.
void append_pairs(const PatchGroups& groups, const int* vertex_of_cell, std::vector<GroupPair>& found) {
  const int row = groups[0].count(), plane = row * groups[1].count();
  for_each_cell(groups, [&](const std::array<int, 3>& at, int cell) {
    std::array<const LineGroups::Neighbours*, 3> near{};
    for (std::size_t d = 0; d < 3; ++d) near[d] = &groups[d].neighbours[static_cast<std::size_t>(at[d])];
    for (std::size_t k = 0; k < near[2]->pairs.size(); ++k)
      for (std::size_t j = 0; j < near[1]->pairs.size(); ++j)
        for (std::size_t i = 0; i < near[0]->pairs.size(); ++i) {
          const int other = near[0]->low + static_cast<int>(i) + row * (near[1]->low + static_cast<int>(j)) +
                            plane * (near[2]->low + static_cast<int>(k));
          const int a = vertex_of_cell[cell], b = vertex_of_cell[other];
          const std::int64_t pairs = near[0]->pairs[i] * near[1]->pairs[j] * near[2]->pairs[k];
          if (a <= b && pairs > 0) found.push_back({a, b, pairs});
        }
  });
}

// Each pair once. Patches that share a pair have it on a common face, and count the same.
void unite(std::vector<GroupPair>& pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const GroupPair& a, const GroupPair& b) {
    return std::array<std::int64_t, 3>{a.first, a.second, -a.pairs} <
           std::array<std::int64_t, 3>{b.first, b.second, -b.pairs};
  });
  const auto same = [](const GroupPair& a, const GroupPair& b) {
    return a.first == b.first && a.second == b.second;
  };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
}

// Multipliers tie the first group of a global node to each other one: vertices of their own behind those of
// the nodes.
void append_multipliers(const GlobalNodes& global, PatternForecast& result, std::vector<GroupPair>& pairs) {
  for (int c = 0; c < global.count(); ++c) {
    const auto members = global.nodes_of(c);
    for (std::size_t m = 1; m < members.size(); ++m) {
      const int rows = std::min(result.groups.rows[static_cast<std::size_t>(members[0])],
                                result.groups.rows[static_cast<std::size_t>(members[m])]);
      const int vertex = result.groups.count();
      result.groups.rows.push_back(rows);
      result.multipliers += rows;
      pairs.push_back({members[0], vertex, 0});
      pairs.push_back({members[m], vertex, 0});
    }
  }
}

void connect(solvers::RowGroups& groups, const std::vector<GroupPair>& pairs) {
  groups.edge_start.assign(groups.rows.size() + 1, 0);
  for (const GroupPair& pair : pairs) {
    if (pair.first == pair.second) continue;
    ++groups.edge_start[static_cast<std::size_t>(pair.first) + 1];
    ++groups.edge_start[static_cast<std::size_t>(pair.second) + 1];
  }
  for (std::size_t g = 1; g < groups.edge_start.size(); ++g) groups.edge_start[g] += groups.edge_start[g - 1];
  groups.neighbours.resize(static_cast<std::size_t>(groups.edge_start.back()));
  std::vector<int> next(groups.edge_start.begin(), groups.edge_start.end() - 1);
  for (const GroupPair& pair : pairs) {
    if (pair.first == pair.second) continue;
    groups.neighbours[static_cast<std::size_t>(next[static_cast<std::size_t>(pair.first)]++)] = pair.second;
    groups.neighbours[static_cast<std::size_t>(next[static_cast<std::size_t>(pair.second)]++)] = pair.first;
  }
}

}  // namespace

PatternForecast forecast_pattern(const geometry::MultiPatch& model, const DirectionKnots& knots,
                                 Coupling coupling, int most_groups) {
  PatternForecast result;
  const std::vector<PatchGroups> patches = patch_groups(knots, most_groups, result.widening);
  std::vector<std::array<int, 3>> sizes;
  for (const PatchGroups& groups : patches)
    sizes.push_back({groups[0].count(), groups[1].count(), groups[2].count()});
  // Groups are tied as nodes are: by their numbers.
  const GlobalNodes global = global_nodes(model, sizes);
  const bool merged = coupling == Coupling::elimination;
  const int cells = static_cast<int>(global.global_of.size());

  std::vector<int> vertex(static_cast<std::size_t>(cells));
  result.groups.rows.assign(static_cast<std::size_t>(merged ? global.count() : cells), 1 << 30);
  int first = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    for_each_cell(patches[p], [&](const std::array<int, 3>& at, int cell) {
      const auto node = static_cast<std::size_t>(first + cell);
      vertex[node] = merged ? global.global_of[node] : first + cell;
      const int size = size_of(patches[p], at);
      result.nodes += size;
      // The nodes of a collapsed edge are one, as its corner is.
      int& rows = result.groups.rows[static_cast<std::size_t>(vertex[node])];
      rows = std::min(rows, size);
    });
    first += sizes[p][0] * sizes[p][1] * sizes[p][2];
  }
  std::vector<GroupPair> pairs;
  first = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    append_pairs(patches[p], vertex.data() + first, pairs);
    first += sizes[p][0] * sizes[p][1] * sizes[p][2];
  }
  unite(pairs);
  for (const int rows : result.groups.rows) result.rows += rows;
  std::int64_t twice = result.rows;  // the diagonal counts once
  for (const GroupPair& pair : pairs) {
    const std::int64_t most = std::int64_t{result.groups.rows[static_cast<std::size_t>(pair.first)]} *
                              result.groups.rows[static_cast<std::size_t>(pair.second)];
    twice += (pair.first == pair.second ? 1 : 2) * std::min(pair.pairs, most);
  }
  result.blocks = twice / 2;
  if (!merged) append_multipliers(global, result, pairs);
  result.multipliers *= 3;
  for (int& rows : result.groups.rows) rows *= 3;
  connect(result.groups, pairs);
  return result;
}

}  // namespace isopatch::iga
