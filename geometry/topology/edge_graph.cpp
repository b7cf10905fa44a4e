#include "geometry/topology/edge_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"

namespace isopatch::geometry {
namespace {

std::size_t index(VertexId id) {
  return static_cast<std::size_t>(id.value);
}
std::size_t index(EdgeId id) {
  return static_cast<std::size_t>(id.value);
}

// Faces that are connected by edges.
UnionFind shells(const EdgeGraph& graph, const std::vector<std::vector<EdgeGraph::Place>>& used) {
  UnionFind faces(static_cast<int>(graph.faces.size()));
  for (const auto& at : used)
    for (const EdgeGraph::Place& place : at) faces.unite(at.front().face.value, place.face.value);
  return faces;
}

// The edge ends at a vertex are joined by the corners of faces; more than one piece is a pinch.
std::vector<VertexId> pinched(const EdgeGraph& graph) {
  UnionFind ends(2 * static_cast<int>(graph.edges.size()));  // 2 e: at the start of e, 2 e + 1: at its end
  for (const EdgeGraph::Face& face : graph.faces)
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const EdgeUse arriving = loop[i], leaving = loop[(i + 1) % loop.size()];
        ends.unite(2 * arriving.edge.value + (arriving.reversed ? 0 : 1),
                   2 * leaving.edge.value + (leaving.reversed ? 1 : 0));
      }
  std::vector<std::vector<int>> fans(static_cast<std::size_t>(graph.vertex_count));
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    for (const auto& [vertex, end] :
         {std::pair(graph.edge(EdgeId(e)).start, 2 * e), std::pair(graph.edge(EdgeId(e)).end, 2 * e + 1)})
      fans[index(vertex)].push_back(ends.find(end));
  std::vector<VertexId> result;
  for (std::size_t v = 0; v < fans.size(); ++v) {
    std::sort(fans[v].begin(), fans[v].end());
    const auto last = std::unique(fans[v].begin(), fans[v].end());
    if (last - fans[v].begin() > 1) result.emplace_back(static_cast<int>(v));
  }
  return result;
}

}  // namespace

EdgeGraph edge_graph(int vertex_count, const std::vector<std::vector<int>>& faces) {
  EdgeGraph graph;
  graph.vertex_count = vertex_count;
  std::map<std::pair<int, int>, EdgeId> known;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<EdgeUse> loop;
    const std::vector<int>& polygon = faces[f];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int from = polygon[i], to = polygon[(i + 1) % polygon.size()];
      if (from < 0 || from >= vertex_count || from == to)
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("face {} goes from vertex {} to {}; they must differ and lie below {}", f,
                                from, to, vertex_count));
      const auto [found, is_new] =
          known.try_emplace(std::minmax(from, to), EdgeId(static_cast<int>(graph.edges.size())));
      if (is_new) graph.edges.push_back({VertexId(from), VertexId(to)});
      loop.push_back({found->second, graph.edge(found->second).start != VertexId(from)});
    }
    graph.faces.push_back({{std::move(loop)}});
  }
  return graph;
}

std::vector<VertexId> corners(const EdgeGraph& graph, const std::vector<EdgeUse>& loop) {
  std::vector<VertexId> result;
  for (const EdgeUse use : loop) result.push_back(graph.from(use));
  return result;
}

std::vector<std::vector<EdgeGraph::Place>> places(const EdgeGraph& graph) {
  std::vector<std::vector<EdgeGraph::Place>> result(graph.edges.size());
  for (std::size_t f = 0; f < graph.faces.size(); ++f)
    for (std::size_t l = 0; l < graph.faces[f].loops.size(); ++l)
      for (std::size_t i = 0; i < graph.faces[f].loops[l].size(); ++i) {
        const EdgeUse use = graph.faces[f].loops[l][i];
        result[index(use.edge)].push_back(
            {FaceId(static_cast<int>(f)), static_cast<int>(l), static_cast<int>(i), use.reversed});
      }
  return result;
}

std::vector<int> degrees(const EdgeGraph& graph) {
  std::vector<int> result(static_cast<std::size_t>(graph.vertex_count));
  for (const EdgeGraph::Edge& edge : graph.edges) {
    ++result[index(edge.start)];
    ++result[index(edge.end)];
  }
  return result;
}

BoundaryReport boundary(const EdgeGraph& graph) {
  BoundaryReport report;
  const auto used = places(graph);
  for (std::size_t e = 0; e < used.size(); ++e) {
    const EdgeId id(static_cast<int>(e));
    if (used[e].size() < 2) report.free_edges.push_back(id);
    if (used[e].size() > 2) report.overused_edges.push_back(id);
    if (used[e].size() == 2 && used[e][0].reversed == used[e][1].reversed)
      report.misoriented_edges.push_back(id);
  }
  report.pinched_vertices = pinched(graph);
  report.shells = shells(graph, used).set_count();
  return report;
}

TopologyReport topology(const EdgeGraph& graph, const BoundaryReport& boundary) {
  TopologyReport report;
  report.euler_characteristic = graph.vertex_count - static_cast<int>(graph.edges.size());
  for (std::size_t f = 0; f < graph.faces.size(); ++f) {
    const auto& loops = graph.faces[f].loops;
    report.euler_characteristic += 2 - static_cast<int>(loops.size());
    const FaceId id(static_cast<int>(f));
    if (loops.size() > 1) report.with_inner_loops.push_back(id);
    std::vector<int> used;
    for (const auto& loop : loops)
      for (const EdgeUse use : loop) used.push_back(use.edge.value);
    std::sort(used.begin(), used.end());
    if (std::adjacent_find(used.begin(), used.end()) != used.end()) report.periodic.push_back(id);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    if (graph.edges[e].start == graph.edges[e].end) report.closed_edges.emplace_back(static_cast<int>(e));
  if (boundary.bounds_a_solid()) {
    report.genus = boundary.shells - report.euler_characteristic / 2;
    report.contractible = boundary.shells == 1 && report.genus == 0;
  }
  return report;
}

std::vector<ShellCharacteristic> shell_characteristics(const EdgeGraph& graph) {
  const auto used = places(graph);
  UnionFind joined = shells(graph, used);
  std::map<int, std::size_t> number;  // of a shell, by its lowest face
  std::vector<ShellCharacteristic> result;
  std::vector<std::set<int>> vertices;
  const auto shell_of = [&](FaceId face) {
    const auto [found, is_new] = number.try_emplace(joined.find(face.value), result.size());
    if (is_new) {
      result.emplace_back();
      vertices.emplace_back();
    }
    return found->second;
  };
  for (std::size_t f = 0; f < graph.faces.size(); ++f) {
    const FaceId id(static_cast<int>(f));
    ShellCharacteristic& shell = result[shell_of(id)];
    shell.faces.push_back(id);
    shell.value += 2 - static_cast<int>(graph.faces[f].loops.size());
  }
  for (std::size_t e = 0; e < used.size(); ++e) {
    if (used[e].empty()) continue;
    const std::size_t shell = shell_of(used[e].front().face);
    --result[shell].value;
    vertices[shell].insert({graph.edges[e].start.value, graph.edges[e].end.value});
  }
  for (std::size_t s = 0; s < result.size(); ++s) result[s].value += static_cast<int>(vertices[s].size());
  return result;
}

}  // namespace isopatch::geometry
