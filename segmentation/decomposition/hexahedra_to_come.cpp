#include "segmentation/decomposition/hexahedra_to_come.hpp"

#include <cstddef>
#include <optional>

#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/divided_edges.hpp"

namespace isopatch::segmentation {
namespace {

/// As many as the vertices, and more where it must be cut at vertices before.
double of_other(const CellGraph& graph) {
  // Every edge has two ends; three of them at each vertex cost nothing more.
  const double too_many = 2.0 * static_cast<double>(graph.edges.size()) - 3.0 * graph.vertex_count;
  return graph.vertex_count + 6 * too_many;
}

double of_one(const CellSides& cell, const DividedEdges& divided) {
  const std::optional<BaseSolid> base = base_solid(cell.graph);
  if (!base || (base->kind != BaseKind::hexahedron && base->kind != BaseKind::prism))
    return of_other(cell.graph);
  const auto parts = [&](std::size_t a, std::size_t b) {
    const EdgeId row = *edge_between(cell.graph, base->corners[a], base->corners[b]);
    return divided.contains(cell.edges[static_cast<std::size_t>(row.value)].front().edge) ? 2.0 : 1.0;
  };
  const double levels = parts(0, static_cast<std::size_t>(base->sides));
  return base->kind == BaseKind::prism ? levels * base->sides : levels * parts(0, 1) * parts(1, 2);
}

}  // namespace

double hexahedra_to_come(const geometry::CellComplex& complex, const std::vector<CellSides>& cells) {
  const DividedEdges divided(complex, cells);
  double sum = 0;
  for (const CellSides& cell : cells) sum += of_one(cell, divided);
  return sum;
}

}  // namespace isopatch::segmentation
