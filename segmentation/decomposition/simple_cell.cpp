#include "segmentation/decomposition/simple_cell.hpp"

#include <algorithm>
#include <vector>

#include "segmentation/decomposition/combinatorics/base_solid.hpp"

namespace isopatch::segmentation {
namespace {

std::vector<int> degrees(const CellGraph& graph) {
  std::vector<int> result(static_cast<std::size_t>(graph.vertex_count), 0);
  for (const CellGraph::Edge& edge : graph.edges) {
    ++result[static_cast<std::size_t>(edge.start.value)];
    ++result[static_cast<std::size_t>(edge.end.value)];
  }
  return result;
}

}  // namespace

bool is_simple(const CellGraph& graph) {
  const std::vector<int> degree = degrees(graph);
  return std::all_of(degree.begin(), degree.end(), [](int d) { return d == 3; });
}

double hexahedra_of(const CellGraph& graph) {
  if (const auto base = base_solid(graph)) {
    if (base->kind == BaseKind::hexahedron) return 1;
    if (base->kind == BaseKind::prism) return base->sides;
  }
  double sum = graph.vertex_count;
  for (const int d : degrees(graph)) sum += 6.0 * (d - 3);
  return sum;
}

}  // namespace isopatch::segmentation
