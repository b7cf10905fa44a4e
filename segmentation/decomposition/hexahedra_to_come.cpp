#include "segmentation/decomposition/hexahedra_to_come.hpp"

#include <cstddef>
#include <optional>
#include <set>

#include "geometry/base/union_find.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/simple_cell.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;

/// Which edges of a complex are divided together, and which are.
class DividedEdges {
 public:
  DividedEdges(const geometry::CellComplex& complex, const std::vector<CellSides>& cells)
      : together_(static_cast<int>(complex.edges.size())) {
    for (const CellSides& cell : cells)
      for (const auto& chain : cell.edges)
        for (const EdgeUse& use : chain) together_.unite(chain.front().edge.value, use.edge.value);
    for (const CellSides& cell : cells)
      for (const CellGraph::Corners& corners : cell.graph.faces)
        if (corners.size() == 4)
          for (const std::size_t k : {0U, 1U})
            together_.unite(edge(cell, corners[k], corners[k + 1]),
                            edge(cell, corners[k + 2], corners[(k + 3) % 4]));
    for (const CellSides& cell : cells)
      for (const CellGraph::Corners& corners : cell.graph.faces)
        if (corners.size() != 4)
          for (std::size_t k = 0; k < corners.size(); ++k)
            divided_.insert(together_.find(edge(cell, corners[k], corners[(k + 1) % corners.size()])));
  }

  bool contains(const CellSides& cell, VertexId a, VertexId b) {
    return divided_.contains(together_.find(edge(cell, a, b)));
  }

 private:
  static int edge(const CellSides& cell, VertexId a, VertexId b) {
    return cell.edges[static_cast<std::size_t>(edge_between(cell.graph, a, b)->value)].front().edge.value;
  }

  UnionFind together_;
  std::set<int> divided_;
};

double of_one(const CellSides& cell, DividedEdges& divided) {
  const std::optional<BaseSolid> base = base_solid(cell.graph);
  if (!base || (base->kind != BaseKind::hexahedron && base->kind != BaseKind::prism))
    return hexahedra_of(cell.graph);
  const std::vector<VertexId>& at = base->corners;
  const auto sides = static_cast<std::size_t>(base->sides);
  const double levels = divided.contains(cell, at[0], at[sides]) ? 2 : 1;
  if (base->kind == BaseKind::prism) return levels * base->sides;
  return levels * (divided.contains(cell, at[0], at[1]) ? 2 : 1) *
         (divided.contains(cell, at[1], at[2]) ? 2 : 1);
}

}  // namespace

double hexahedra_to_come(const geometry::CellComplex& complex, const std::vector<CellSides>& cells) {
  DividedEdges divided(complex, cells);
  double sum = 0;
  for (const CellSides& cell : cells) sum += of_one(cell, divided);
  return sum;
}

}  // namespace isopatch::segmentation
