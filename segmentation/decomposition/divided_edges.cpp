#include "segmentation/decomposition/divided_edges.hpp"

#include <cstddef>

namespace isopatch::segmentation {
namespace {

/// The edges around a side, the first of each row.
std::vector<EdgeId> around(const CellSides& cell, const CellGraph::Corners& corners) {
  std::vector<EdgeId> result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const EdgeId row = *edge_between(cell.graph, corners[k], corners[(k + 1) % corners.size()]);
    result.push_back(cell.edges[static_cast<std::size_t>(row.value)].front().edge);
  }
  return result;
}

}  // namespace

DividedEdges::DividedEdges(const geometry::CellComplex& complex, const std::vector<CellSides>& cells)
    : together_(static_cast<int>(complex.edges.size())) {
  std::vector<EdgeId> divided;
  for (const CellSides& cell : cells) {
    for (const auto& row : cell.edges)
      for (const geometry::EdgeUse& use : row) together_.unite(row.front().edge.value, use.edge.value);
    for (const CellGraph::Corners& corners : cell.graph.faces) {
      const std::vector<EdgeId> edges = around(cell, corners);
      if (edges.size() == 4)
        for (const std::size_t k : {0U, 1U}) together_.unite(edges[k].value, edges[k + 2].value);
      else
        divided.insert(divided.end(), edges.begin(), edges.end());
    }
  }
  for (const EdgeId edge : divided) divided_.insert(together_.find(edge.value));
}

}  // namespace isopatch::segmentation
