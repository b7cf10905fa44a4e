#include "segmentation/decomposition/combinatorics/constructive_loop.hpp"

#include <algorithm>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/loop_validity.hpp"

namespace isopatch::segmentation {
namespace {

std::vector<LoopPlace> neighbours(const CellGraph& graph, const CellIncidence& incidence, VertexId vertex) {
  std::vector<LoopPlace> result;
  for (const EdgeId id : incidence.edges_at(vertex))
    result.push_back(
        LoopPlace::at(graph.edge(id).start == vertex ? graph.edge(id).end : graph.edge(id).start));
  return result;
}

// A valid loop near a vertex: through it and two of its neighbours that share a face without being next to
// each other around it, or, where there are no such two, through all its neighbours.
CuttingLoop loop_at(const CellGraph& graph, const CellIncidence& incidence, VertexId vertex) {
  const std::vector<LoopPlace> near = neighbours(graph, incidence, vertex);
  const int degree = static_cast<int>(near.size());
  for (int a = 0; a < degree; ++a)
    for (int b = a + 2; b < degree; ++b) {
      if (b - a == degree - 1) continue;
      if (!incidence.common_faces(near[a].vertex, near[b].vertex).empty())
        return loop_through(graph, incidence, {LoopPlace::at(vertex), near[a], near[b]});
    }
  return loop_through(graph, incidence, near);
}

}  // namespace

CuttingLoop constructive_loop(const CellGraph& graph) {
  if (!is_three_connected(graph))
    throw Error(ErrorCode::not_three_connected, "a cell that two vertices take apart may have no valid loop");
  if (graph.vertex_count == 4)
    throw Error(ErrorCode::unsupported, "a tetrahedron has no valid loop; it is a base solid");
  const CellIncidence incidence(graph);
  std::optional<CuttingLoop> best;
  for (int v = 0; v < graph.vertex_count; ++v) {
    CuttingLoop loop = loop_at(graph, incidence, VertexId(v));
    if (why_invalid(graph, incidence, loop)) continue;
    if (!best || loop.length() < best->length()) best = std::move(loop);
  }
  if (!best) throw Error(ErrorCode::internal, "a 3-connected cell without a valid loop, against the theorem");
  return *best;
}

}  // namespace isopatch::segmentation
