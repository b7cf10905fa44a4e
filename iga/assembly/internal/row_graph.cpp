#include "iga/assembly/internal/row_graph.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

template <class Part, class Visit>
void for_each_node(const Part& part, Visit visit) {
  for (int k = 0, local = 0; k < part.sizes[2]; ++k) {
    const int plane = part.sizes[0] * part.sizes[1];
    if (part.overlaps[2][static_cast<std::size_t>(k)].empty()) {
      local += plane;
      continue;
    }
    for (const int end = local + plane; local < end; ++local) visit(local);
  }
}

// Sorts and joins intervals that touch or overlap.
void merge(std::vector<RowInterval>& intervals) {
  const auto before = [](const RowInterval& a, const RowInterval& b) { return a.begin < b.begin; };
  if (!std::is_sorted(intervals.begin(), intervals.end(), before))
    std::sort(intervals.begin(), intervals.end(), before);
  std::size_t kept = 0;
  for (std::size_t i = 1; i < intervals.size(); ++i) {
    if (intervals[i].begin <= intervals[kept].end)
      intervals[kept].end = std::max(intervals[kept].end, intervals[i].end);
    else
      intervals[++kept] = intervals[i];
  }
  intervals.resize(kept + 1);
}

}  // namespace

RowGraph::RowGraph(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                   const RowNumbering& numbering)
    : row_of_node_(&numbering.row_of_node) {
  std::vector<int> first_node = {0};
  for (const PatchSpace& space : spaces) first_node.push_back(first_node.back() + space.size());
  if (first_node.back() != static_cast<int>(numbering.row_of_node.size()))
    throw Error(ErrorCode::invalid_argument, fmt::format("the numbering has {} nodes, the spaces have {}",
                                                         numbering.row_of_node.size(), first_node.back()));
  for (const PatchLayers& part : parts) {
    if (part.patch < 0 || part.patch >= static_cast<int>(spaces.size()))
      throw Error(ErrorCode::invalid_argument, fmt::format("there is no patch {}", part.patch));
    const PatchSpace& space = spaces[static_cast<std::size_t>(part.patch)];
    if (part.first_layer < 0 || part.first_layer > part.last_layer ||
        part.last_layer > space.knots[2].element_count())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("layers {} .. {} of patch {}, which has {}", part.first_layer, part.last_layer,
                              part.patch, space.knots[2].element_count()));
    parts_.push_back({{overlaps(space.knots[0]), overlaps(space.knots[1]),
                       overlaps(space.knots[2], part.first_layer, part.last_layer)},
                      space.sizes(),
                      first_node[static_cast<std::size_t>(part.patch)],
                      true});
  }
  check(numbering);
  node_start_.assign(static_cast<std::size_t>(numbering.rows) + 1, 0);
  const auto row_at = [&](const Part& part, int local) {
    return static_cast<std::size_t>(numbering.row_of_node[static_cast<std::size_t>(part.first_node + local)]);
  };
  for (const Part& part : parts_)
    for_each_node(part, [&](int local) { ++node_start_[row_at(part, local) + 1]; });
  for (std::size_t r = 1; r < node_start_.size(); ++r) node_start_[r] += node_start_[r - 1];
  nodes_.resize(static_cast<std::size_t>(node_start_.back()));
  std::vector<std::int64_t> next(node_start_.begin(), node_start_.end() - 1);
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for_each_node(parts_[p], [&](int local) {
      nodes_[static_cast<std::size_t>(next[row_at(parts_[p], local)]++)] = {static_cast<int>(p), local};
    });
  mark_simple(parts);
}

void RowGraph::check(const RowNumbering& numbering) const {
  for (const Part& part : parts_)
    for_each_node(part, [&](int local) {
      const int row = numbering.row_of_node[static_cast<std::size_t>(part.first_node + local)];
      if (row < 0 || row >= numbering.rows)
        throw Error(ErrorCode::invalid_argument, fmt::format("node {} has row {}, there are {}",
                                                             part.first_node + local, row, numbering.rows));
    });
}

void RowGraph::mark_simple(const std::vector<PatchLayers>& parts) {
  for (int row = 0; row < rows(); ++row) {
    const auto nodes = nodes_of(row);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      // Nodes come by part, so those of one part are neighbours in the list.
      if (nodes[i].part == nodes[i - 1].part) parts_[static_cast<std::size_t>(nodes[i].part)].simple = false;
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      if (parts[p].patch == parts[q].patch) parts_[p].simple = parts_[q].simple = false;
}

std::span<const RowGraph::Node> RowGraph::nodes_of(int row) const {
  const auto begin = static_cast<std::size_t>(node_start_[static_cast<std::size_t>(row)]);
  const auto end = static_cast<std::size_t>(node_start_[static_cast<std::size_t>(row) + 1]);
  return {nodes_.data() + begin, end - begin};
}

std::array<const Overlap*, 3> RowGraph::overlaps_of(const Node& node) const {
  const Part& part = parts_[static_cast<std::size_t>(node.part)];
  const auto at = [&](std::size_t d, int i) { return &part.overlaps[d][static_cast<std::size_t>(i)]; };
  return {at(0, node.local % part.sizes[0]), at(1, node.local / part.sizes[0] % part.sizes[1]),
          at(2, node.local / part.sizes[0] / part.sizes[1])};
}

void RowGraph::neighbours(int row, int lowest, std::vector<RowInterval>& found) const {
  found.clear();
  if (row >= lowest) found.push_back({row, row + 1});
  for (const Node& node : nodes_of(row)) {
    const Part& part = parts_[static_cast<std::size_t>(node.part)];
    const auto [u, v, w] = overlaps_of(node);
    for (int k = w->low; k <= w->high; ++k) {
      for (int j = v->low; j <= v->high; ++j) {
        const int line = part.first_node + part.sizes[0] * (j + part.sizes[1] * k);
        for (int i = u->low; i <= u->high; ++i) {
          const int column = (*row_of_node_)[static_cast<std::size_t>(line + i)];
          if (column < lowest) continue;
          if (!found.empty() && column == found.back().end)
            ++found.back().end;
          else
            found.push_back({column, column + 1});
        }
      }
    }
  }
  if (found.size() > 1) merge(found);
}

std::int64_t RowGraph::neighbour_count(int row, std::vector<RowInterval>& scratch) const {
  const auto nodes = nodes_of(row);
  if (nodes.size() == 1 && parts_[static_cast<std::size_t>(nodes[0].part)].simple) {
    const auto [u, v, w] = overlaps_of(nodes[0]);
    return static_cast<std::int64_t>(u->count()) * v->count() * w->count();
  }
  neighbours(row, 0, scratch);
  std::int64_t count = 0;
  for (const RowInterval& interval : scratch) count += interval.end - interval.begin;
  return count;
}

}  // namespace isopatch::iga
