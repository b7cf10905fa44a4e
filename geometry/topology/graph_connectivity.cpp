#include "geometry/topology/graph_connectivity.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace isopatch::geometry {
namespace {

bool is_connected(const EdgeGraph& graph) {
  if (graph.vertex_count == 0) return false;
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(graph.vertex_count));
  for (const EdgeGraph::Edge& edge : graph.edges) {
    neighbours[static_cast<std::size_t>(edge.start.value)].push_back(edge.end.value);
    neighbours[static_cast<std::size_t>(edge.end.value)].push_back(edge.start.value);
  }
  std::vector<bool> seen(neighbours.size());
  std::vector<int> open = {0};
  seen[0] = true;
  std::size_t count = 1;
  while (!open.empty()) {
    const int vertex = open.back();
    open.pop_back();
    for (const int other : neighbours[static_cast<std::size_t>(vertex)]) {
      if (seen[static_cast<std::size_t>(other)]) continue;
      seen[static_cast<std::size_t>(other)] = true;
      ++count;
      open.push_back(other);
    }
  }
  return count == neighbours.size();
}

void find_parallel(const EdgeGraph& graph, ConnectivityReport& report) {
  std::set<std::pair<VertexId, VertexId>> known;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto& [start, end] = graph.edges[e];
    if (start == end)
      report.loops.emplace_back(static_cast<int>(e));
    else if (!known.insert(std::minmax(start, end)).second)
      report.parallel.emplace_back(static_cast<int>(e));
  }
}

/// Faces around each vertex and edges around each face, for the search of conflicts.
class ConflictSearch {
 public:
  explicit ConflictSearch(const EdgeGraph& graph)
      : graph_(graph), at_(static_cast<std::size_t>(graph.vertex_count)) {
    for (std::size_t f = 0; f < graph.faces.size(); ++f) {
      std::vector<VertexId> around;
      for (const auto& loop : graph.faces[f].loops)
        for (const VertexId vertex : corners(graph, loop)) around.push_back(vertex);
      for (const VertexId vertex : around)
        at_[static_cast<std::size_t>(vertex.value)].push_back(FaceId(static_cast<int>(f)));
      corners_.push_back(std::move(around));
    }
    for (const auto& used : places(graph)) {
      std::vector<FaceId> faces;
      for (const EdgeGraph::Place& place : used) faces.push_back(place.face);
      faces_.push_back(std::move(faces));
    }
  }

  std::optional<FaceConflict> first() const {
    for (std::size_t f = 0; f < corners_.size(); ++f)
      if (const auto found = first_of(FaceId(static_cast<int>(f)))) return found;
    return std::nullopt;
  }

 private:
  std::optional<FaceConflict> first_of(FaceId face) const {
    std::map<FaceId, std::vector<VertexId>> shared;
    std::set<VertexId> seen;
    for (const VertexId vertex : corners_[static_cast<std::size_t>(face.value)]) {
      if (!seen.insert(vertex).second) return FaceConflict{face, face, vertex, vertex};
      for (const FaceId other : at_[static_cast<std::size_t>(vertex.value)])
        if (face < other) shared[other].push_back(vertex);
    }
    for (const auto& [other, vertices] : shared)
      if (vertices.size() > 2 || (vertices.size() == 2 && !joined(face, other, vertices[0], vertices[1])))
        return conflict(face, other, vertices);
    return std::nullopt;
  }

  // Of three or more common vertices, two that no common edge joins, if there are such.
  FaceConflict conflict(FaceId face, FaceId other, const std::vector<VertexId>& vertices) const {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!joined(face, other, vertices[j], vertices[i])) return {face, other, vertices[j], vertices[i]};
    return {face, other, vertices[0], vertices[1]};
  }

  bool joined(FaceId a, FaceId b, VertexId u, VertexId v) const {
    for (const auto& loop : graph_.face(a).loops)
      for (const EdgeUse use : loop) {
        const auto& [start, end] = graph_.edge(use.edge);
        if (std::minmax(start, end) != std::minmax(u, v)) continue;
        const auto& faces = faces_[static_cast<std::size_t>(use.edge.value)];
        if (std::find(faces.begin(), faces.end(), b) != faces.end()) return true;
      }
    return false;
  }

  const EdgeGraph& graph_;
  std::vector<std::vector<FaceId>> at_;
  std::vector<std::vector<VertexId>> corners_;
  std::vector<std::vector<FaceId>> faces_;
};

}  // namespace

ConnectivityReport connectivity(const EdgeGraph& graph, const TopologyReport& topology) {
  ConnectivityReport report;
  report.connected = is_connected(graph);
  find_parallel(graph, report);
  const std::vector<int> degree = degrees(graph);
  for (std::size_t v = 0; v < degree.size(); ++v)
    if (degree[v] < 3) report.low_degree.emplace_back(static_cast<int>(v));
  report.conflict = ConflictSearch(graph).first();
  report.three_connected = topology.contractible && topology.faces_are_discs() && report.connected &&
                           report.simple() && report.low_degree.empty() && !report.conflict &&
                           graph.vertex_count >= 4;
  return report;
}

bool is_cube(const EdgeGraph& graph, const ConnectivityReport& report) {
  const std::vector<int> degree = degrees(graph);
  return report.three_connected && graph.vertex_count == 8 && graph.faces.size() == 6 &&
         std::all_of(degree.begin(), degree.end(), [](int d) { return d == 3; }) &&
         std::all_of(graph.faces.begin(), graph.faces.end(),
                     [](const EdgeGraph::Face& face) { return face.loops.front().size() == 4; });
}

}  // namespace isopatch::geometry
