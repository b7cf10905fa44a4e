#include "segmentation/decomposition/combinatorics/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

// Edge e of the derived graph, and the vertex put inside it.
VertexId put_vertex_on(DerivedGraph& derived, EdgeId id) {
  const VertexId middle(derived.graph.vertex_count++);
  const CellGraph::Edge whole = derived.graph.edge(id);
  const EdgeStretch stretch = derived.edges[id.value].front();
  const LoopPlace place = LoopPlace::inside(stretch.edge);
  derived.vertices.push_back(place);
  derived.graph.edges[id.value].end = middle;
  derived.graph.edges.push_back({middle, whole.end, whole.kind, whole.angle});
  derived.edges[id.value] = {{stretch.from, place, stretch.edge, FaceId()}};
  derived.edges.push_back({{place, stretch.to, stretch.edge, FaceId()}});
  for (CellGraph::Corners& face : derived.graph.faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      if (std::minmax(face[k], face[(k + 1) % face.size()]) == std::minmax(whole.start, whole.end)) {
        face.insert(face.begin() + static_cast<std::ptrdiff_t>(k) + 1, middle);
        break;
      }
  return middle;
}

void divide_face(DerivedGraph& derived, FaceId id, VertexId from, VertexId to) {
  CellGraph::Corners& face = derived.graph.faces[id.value];
  // Left of the new edge lies what the face walks from its end to its start.
  std::rotate(face.begin(), std::find(face.begin(), face.end(), to), face.end());
  const auto start = std::find(face.begin(), face.end(), from);
  CellGraph::Corners right(start, face.end());
  right.push_back(to);
  face.erase(start + 1, face.end());
  derived.graph.faces.push_back(std::move(right));
  derived.faces.push_back(derived.faces[id.value]);
  derived.graph.edges.push_back({from, to, EdgeKind::flat, Angle::degrees(180)});
  derived.edges.push_back({{derived.vertices[from.value], derived.vertices[to.value], EdgeId(),
                            derived.faces[id.value].faces.front()}});
}

bool has(const CellGraph::Corners& face, VertexId vertex) {
  return std::find(face.begin(), face.end(), vertex) != face.end();
}

// The part of a face that has both vertices.
std::optional<FaceId> part_with(const DerivedGraph& derived, FaceId face, VertexId a, VertexId b) {
  for (int f = 0; f < static_cast<int>(derived.faces.size()); ++f)
    if (derived.faces[f].faces.front() == face && has(derived.graph.faces[f], a) &&
        has(derived.graph.faces[f], b))
      return FaceId(f);
  return std::nullopt;
}

void check_edge(const CellGraph& graph, EdgeId edge) {
  if (edge.value < 0 || edge.value >= static_cast<int>(graph.edges.size()))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("there is no edge {}; the cell has {}", edge.value, graph.edges.size()));
}

}  // namespace

DerivedGraph with_vertex_on_edge(const CellGraph& graph, EdgeId edge) {
  check_edge(graph, edge);
  DerivedGraph result = identity(graph);
  put_vertex_on(result, edge);
  return result;
}

DerivedGraph with_edge_across_face(const CellGraph& graph, FaceId face, VertexId from, VertexId to) {
  if (face.value < 0 || face.value >= static_cast<int>(graph.faces.size()))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("there is no face {}; the cell has {}", face.value, graph.faces.size()));
  if (!has(graph.face(face), from) || !has(graph.face(face), to) || from == to ||
      edge_between(graph, from, to))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("an edge across face {} needs two of its corners that no edge joins, not {} and {}",
                    face.value, from.value, to.value));
  DerivedGraph result = identity(graph);
  divide_face(result, face, from, to);
  return result;
}

std::optional<RefinedAlongLoop> refined_along(const CellGraph& graph, const CuttingLoop& loop) {
  check_places(graph, loop.places);
  RefinedAlongLoop result{identity(graph), {}};
  for (const LoopPlace& place : loop.places)
    result.loop.push_back(place.auxiliary() ? put_vertex_on(result.derived, place.edge) : place.vertex);
  for (std::size_t k = 0; k < loop.steps.size(); ++k) {
    if (!loop.steps[k].auxiliary()) continue;
    const VertexId from = result.loop[k], to = result.loop[(k + 1) % result.loop.size()];
    const auto part = part_with(result.derived, loop.steps[k].face, from, to);
    if (!part) return std::nullopt;
    divide_face(result.derived, *part, from, to);
  }
  return result;
}

}  // namespace isopatch::segmentation
