#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"

#include <algorithm>
#include <string>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/internal/planar_map.hpp"

namespace isopatch::segmentation {
namespace {

[[noreturn]] void fail_not_a_ball(const char* what) {
  throw Error(ErrorCode::not_manifold,
              std::string("the graph of a cell does not bound a ball: ") + what +
                  "; check that its faces are discs, walk counter-clockwise seen from outside, and close");
}

// The edge of each dart.
std::vector<EdgeId> edges_of_darts(const CellGraph& graph, const PlanarMap& map, const Darts& darts) {
  std::vector<EdgeId> edges(map.corners.size());
  if (2 * graph.edges.size() != edges.size()) fail_not_a_ball("its edges are not the sides of its faces");
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
    const auto& [start, end, kind, angle] = graph.edges[e];
    if (std::min(start, end) < VertexId(0) || std::max(start, end) >= VertexId(graph.vertex_count))
      fail_not_a_ball("an edge ends at no vertex");
    const int dart = darts.between(map, start.value, end.value);
    if (dart < 0 || edges[dart].value >= 0) fail_not_a_ball("its edges are not the sides of its faces");
    edges[dart] = edges[darts.twin[dart]] = EdgeId(e);
  }
  return edges;
}

}  // namespace

CellIncidence::CellIncidence(const CellGraph& graph) {
  for (const CellGraph::Corners& face : graph.faces)
    for (const VertexId vertex : face)
      if (vertex.value < 0 || vertex.value >= graph.vertex_count)
        fail_not_a_ball("a face has a corner that is no vertex");
  const PlanarMap map = planar_map(graph);
  const Darts around = darts(map);
  if (!is_sphere(map, around)) fail_not_a_ball("its faces are no sphere");
  const std::vector<EdgeId> edges = edges_of_darts(graph, map, around);
  sides_of_.resize(graph.edges.size());
  for (int f = 0; f < map.faces(); ++f) {
    sides_.emplace_back(edges.begin() + map.begin[f], edges.begin() + map.begin[f + 1]);
    for (int d = map.begin[f]; d < map.begin[f + 1]; ++d)
      sides_of_[edges[d].value][graph.edge(edges[d]).start.value == map.corners[d] ? 0 : 1] = FaceId(f);
  }
  for (int v = 0; v < map.vertices; ++v) {
    std::vector<EdgeId>& at_edges = edges_at_.emplace_back();
    std::vector<FaceId>& at_faces = faces_at_.emplace_back();
    std::vector<VertexId>& near = neighbours_.emplace_back();
    const int first = around.out[around.out_begin[v]];
    for (int d = first;;) {
      at_edges.push_back(edges[d]);
      at_faces.emplace_back(around.face[d]);
      near.emplace_back(map.corners[around.next[d]]);
      d = around.twin[around.previous[d]];
      if (d == first) break;
    }
  }
}

std::optional<EdgeId> CellIncidence::edge_between(VertexId a, VertexId b) const {
  const std::vector<VertexId>& near = neighbours_[index(a.value)];
  const auto found = std::find(near.begin(), near.end(), b);
  if (found == near.end()) return std::nullopt;
  return edges_at_[index(a.value)][static_cast<std::size_t>(found - near.begin())];
}

std::vector<FaceId> CellIncidence::common_faces(VertexId a, VertexId b) const {
  std::vector<FaceId> result;
  for (const FaceId face : faces_at(a))
    if (std::find(faces_at(b).begin(), faces_at(b).end(), face) != faces_at(b).end()) result.push_back(face);
  return result;
}

bool is_three_connected(const CellGraph& graph) {
  const PlanarMap map = planar_map(graph);
  const Darts around = darts(map);
  return is_sphere(map, around) && is_three_connected(map, around);
}

}  // namespace isopatch::segmentation
