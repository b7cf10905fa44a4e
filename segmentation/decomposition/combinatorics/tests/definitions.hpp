#pragma once

#include <vector>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation::test {

/// Whether the vertices apart from two of them are connected by edges.
inline bool hangs_together_without(const CellGraph& graph, int a, int b) {
  std::vector<std::vector<int>> near(graph.vertex_count);
  for (const CellGraph::Edge& edge : graph.edges) {
    near[edge.start.value].push_back(edge.end.value);
    near[edge.end.value].push_back(edge.start.value);
  }
  std::vector<bool> seen(graph.vertex_count);
  seen[a] = seen[b] = true;
  int start = 0;
  while (seen[start]) ++start;
  std::vector<int> open = {start};
  seen[start] = true;
  int count = 3;
  while (!open.empty()) {
    const int vertex = open.back();
    open.pop_back();
    for (const int other : near[vertex]) {
      if (seen[other]) continue;
      seen[other] = true;
      ++count;
      open.push_back(other);
    }
  }
  return count == graph.vertex_count;
}

/// 3-connectivity as the textbook defines it: any two vertices may go.
inline bool three_connected_by_definition(const CellGraph& graph) {
  if (graph.vertex_count < 4) return false;
  for (int a = 0; a < graph.vertex_count; ++a)
    for (int b = 0; b < a; ++b)
      if (!hangs_together_without(graph, a, b)) return false;
  return true;
}

/// The same with vertices renumbered, faces in another order and started elsewhere, and turned inside out if
/// `mirrored`.
inline CellGraph shuffled(const CellGraph& graph, std::vector<int> numbers, bool mirrored) {
  std::vector<std::vector<int>> faces;
  for (std::size_t f = graph.faces.size(); f-- > 0;) {
    std::vector<int>& face = faces.emplace_back();
    const CellGraph::Corners& corners = graph.faces[f];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t at = (k + f) % corners.size();
      face.push_back(numbers[corners[mirrored ? corners.size() - 1 - at : at].value]);
    }
  }
  return cell_graph(graph.vertex_count, faces);
}

}  // namespace isopatch::segmentation::test
