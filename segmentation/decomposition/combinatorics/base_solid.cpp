#include "segmentation/decomposition/combinatorics/base_solid.hpp"

#include <algorithm>

#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"

namespace isopatch::segmentation {
namespace {

// The base as seen from inside, its lowest vertex first.
std::vector<VertexId> base_corners(const CellGraph::Corners& face) {
  std::vector<VertexId> result(face.rbegin(), face.rend());
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

// The neighbour of a vertex of degree three that is no corner of a face.
std::optional<VertexId> neighbour_off(const CellGraph& graph, const CellIncidence& incidence, VertexId vertex,
                                      const CellGraph::Corners& face) {
  if (incidence.edges_at(vertex).size() != 3) return std::nullopt;
  for (const EdgeId id : incidence.edges_at(vertex)) {
    const CellGraph::Edge& edge = graph.edge(id);
    const VertexId other = edge.start == vertex ? edge.end : edge.start;
    if (std::find(face.begin(), face.end(), other) == face.end()) return other;
  }
  return std::nullopt;
}

BaseKind kind_over(int sides, bool apex) {
  if (apex) return sides == 3 ? BaseKind::tetrahedron : BaseKind::pyramid;
  return sides == 4 ? BaseKind::hexahedron : BaseKind::prism;
}

// The base solid over one face, if it is one: every corner of the base has one more neighbour, all the same
// or all different.
std::optional<BaseSolid> over(const CellGraph& graph, const CellIncidence& incidence, FaceId base) {
  const CellGraph::Corners& face = graph.face(base);
  const int sides = static_cast<int>(face.size()), others = graph.vertex_count - sides;
  if (others != 1 && others != sides) return std::nullopt;
  BaseSolid solid{kind_over(sides, others == 1), sides, base_corners(face), base};
  std::vector<VertexId> top;
  for (const VertexId corner : solid.corners) {
    const auto above = neighbour_off(graph, incidence, corner, face);
    if (!above || (others > 1 && incidence.edges_at(*above).size() != 3)) return std::nullopt;
    top.push_back(*above);
  }
  if (others == 1) top.resize(1);
  solid.corners.insert(solid.corners.end(), top.begin(), top.end());
  std::sort(top.begin(), top.end());
  if (std::adjacent_find(top.begin(), top.end()) != top.end()) return std::nullopt;
  return solid;
}

}  // namespace

const char* name(BaseKind kind) {
  switch (kind) {
    case BaseKind::hexahedron:
      return "hexahedron";
    case BaseKind::prism:
      return "prism";
    case BaseKind::tetrahedron:
      return "tetrahedron";
    case BaseKind::pyramid:
      return "pyramid";
    case BaseKind::simple:
      return "simple solid";
    case BaseKind::convex:
      return "convex solid";
  }
  return "unknown";
}

std::optional<BaseSolid> base_solid(const CellGraph& graph) {
  const int vertices = graph.vertex_count, faces = static_cast<int>(graph.faces.size());
  // Over n corners a pyramid has n + 1 vertices and as many faces, a prism 2 n and n + 2.
  if (vertices != faces && vertices != 2 * (faces - 2)) return std::nullopt;
  const CellIncidence incidence(graph);
  if (!is_three_connected(graph)) return std::nullopt;
  for (int f = 0; f < faces; ++f)
    if (auto solid = over(graph, incidence, FaceId(f))) return solid;
  return std::nullopt;
}

std::optional<BaseSolid> simple_solid(const CellGraph& graph) {
  std::vector<int> degree(static_cast<std::size_t>(graph.vertex_count), 0);
  for (const CellGraph::Edge& edge : graph.edges)
    for (const VertexId end : {edge.start, edge.end}) ++degree[static_cast<std::size_t>(end.value)];
  if (std::any_of(degree.begin(), degree.end(), [](int d) { return d != 3; })) return std::nullopt;
  return BaseSolid{BaseKind::simple, graph.vertex_count, {}, {}};
}

BaseSolid convex_solid(const CellGraph& graph) {
  int tetrahedra = 0;
  for (const CellGraph::Corners& face : graph.faces)
    tetrahedra += face.size() == 3 ? 1 : static_cast<int>(face.size());
  return {BaseKind::convex, tetrahedra, {}, {}};
}

int template_hexahedra(BaseKind kind, int sides) {
  switch (kind) {
    case BaseKind::hexahedron:
      return 1;
    case BaseKind::prism:
      return sides % 2 == 0 ? (sides - 2) / 2 : (sides - 3) / 2 + 3;
    case BaseKind::tetrahedron:
      return 4;
    case BaseKind::pyramid:
      return 4 * (sides - 2);
    case BaseKind::simple:
      return sides;
    case BaseKind::convex:
      return 4 * sides;
  }
  return 0;
}

}  // namespace isopatch::segmentation
