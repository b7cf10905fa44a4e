#include "segmentation/decomposition/combinatorics/origin.hpp"

#include <algorithm>

namespace isopatch::segmentation {
namespace {

LoopPlace place_in_first(const DerivedGraph& first, const LoopPlace& place) {
  if (!place.auxiliary()) return first.vertices[place.vertex.value];
  const std::vector<EdgeStretch>& stretches = first.edges[place.edge.value];
  // Inside an auxiliary edge, or in one of several: nowhere that the first graph has a name for.
  return stretches.size() == 1 && stretches[0].edge.value >= 0 ? LoopPlace::inside(stretches[0].edge)
                                                               : LoopPlace{};
}

void append_stretch(const DerivedGraph& first, const EdgeStretch& stretch, std::vector<EdgeStretch>& result) {
  const LoopPlace from = place_in_first(first, stretch.from), to = place_in_first(first, stretch.to);
  if (stretch.edge.value < 0) {
    result.push_back({from, to, EdgeId(),
                      first.faces[stretch.face.value].faces.empty()
                          ? FaceId()
                          : first.faces[stretch.face.value].faces.front()});
    return;
  }
  std::vector<EdgeStretch> parts = first.edges[stretch.edge.value];
  const CellGraph::Edge& edge = first.graph.edge(stretch.edge);
  const bool reversed = stretch.from == LoopPlace::at(edge.end) || stretch.to == LoopPlace::at(edge.start);
  if (reversed) {
    std::reverse(parts.begin(), parts.end());
    for (EdgeStretch& part : parts) std::swap(part.from, part.to);
  }
  parts.front().from = from;
  parts.back().to = to;
  result.insert(result.end(), parts.begin(), parts.end());
}

}  // namespace

DerivedGraph identity(const CellGraph& graph) {
  DerivedGraph result{graph, {}, {}, {}};
  for (int v = 0; v < graph.vertex_count; ++v) result.vertices.push_back(LoopPlace::at(VertexId(v)));
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    result.edges.push_back(
        {{LoopPlace::at(graph.edges[e].start), LoopPlace::at(graph.edges[e].end), EdgeId(e), FaceId()}});
  for (int f = 0; f < static_cast<int>(graph.faces.size()); ++f) result.faces.push_back({{FaceId(f)}, false});
  return result;
}

DerivedGraph composed(const DerivedGraph& first, const DerivedGraph& second) {
  DerivedGraph result{second.graph, {}, {}, {}};
  for (const LoopPlace& place : second.vertices) result.vertices.push_back(place_in_first(first, place));
  for (const auto& stretches : second.edges) {
    std::vector<EdgeStretch>& edge = result.edges.emplace_back();
    for (const EdgeStretch& stretch : stretches) append_stretch(first, stretch, edge);
  }
  for (const FaceOrigin& face : second.faces) {
    FaceOrigin& origin = result.faces.emplace_back();
    origin.is_new = face.is_new;
    for (const FaceId middle : face.faces) {
      const FaceOrigin& known = first.faces[middle.value];
      origin.is_new = origin.is_new || known.is_new;
      origin.faces.insert(origin.faces.end(), known.faces.begin(), known.faces.end());
    }
    std::sort(origin.faces.begin(), origin.faces.end());
    origin.faces.erase(std::unique(origin.faces.begin(), origin.faces.end()), origin.faces.end());
  }
  return result;
}

}  // namespace isopatch::segmentation
