#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

std::map<std::pair<VertexId, VertexId>, EdgeId> edges_by_ends(const CellGraph& graph) {
  std::map<std::pair<VertexId, VertexId>, EdgeId> known;
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
    const CellGraph::Edge& edge = graph.edges[e];
    if (edge.start == edge.end || !known.emplace(std::minmax(edge.start, edge.end), EdgeId(e)).second)
      throw Error(
          ErrorCode::unsupported,
          fmt::format(
              "edge {} of a cell joins vertices {} and {}, which are one or have an edge already; put a "
              "vertex on it",
              e, edge.start.value, edge.end.value));
  }
  return known;
}

void check_corner(int face, int vertex, int vertex_count) {
  if (vertex < 0 || vertex >= vertex_count)
    throw Error(ErrorCode::invalid_argument, fmt::format("face {} of a cell has vertex {}, range 0 .. {}",
                                                         face, vertex, vertex_count - 1));
}

}  // namespace

const char* name(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::convex:
      return "convex";
    case EdgeKind::flat:
      return "flat";
    case EdgeKind::non_convex:
      return "non-convex";
  }
  return "unknown";
}

CellGraph cell_graph(int vertex_count, const std::vector<std::vector<int>>& faces) {
  CellGraph graph;
  graph.vertex_count = vertex_count;
  std::vector<std::vector<int>> neighbours(std::max(vertex_count, 0));
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    const std::vector<int>& face = faces[f];
    if (face.size() < 3)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("face {} of a cell has {} corners, three are the fewest", f, face.size()));
    CellGraph::Corners& corners = graph.faces.emplace_back();
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      check_corner(f, a, vertex_count);
      check_corner(f, b, vertex_count);
      corners.emplace_back(a);
      std::vector<int>& known = neighbours[std::min(a, b)];
      if (std::find(known.begin(), known.end(), std::max(a, b)) != known.end()) continue;
      known.push_back(std::max(a, b));
      graph.edges.push_back({VertexId(a), VertexId(b), EdgeKind::convex, std::nullopt});
    }
  }
  return graph;
}

CellGraph cell_graph(const geometry::EdgeGraph& graph) {
  CellGraph result;
  result.vertex_count = graph.vertex_count;
  for (const auto& edge : graph.edges)
    result.edges.push_back({edge.start, edge.end, EdgeKind::convex, std::nullopt});
  edges_by_ends(result);
  for (std::size_t f = 0; f < graph.faces.size(); ++f) {
    if (graph.faces[f].loops.size() != 1)
      throw Error(ErrorCode::unsupported,
                  fmt::format("face {} of a cell has {} loops; cut the solid so that each has one", f,
                              graph.faces[f].loops.size()));
    result.faces.push_back(geometry::corners(graph, graph.faces[f].loops.front()));
  }
  return result;
}

geometry::EdgeGraph edge_graph(const CellGraph& graph) {
  const auto known = edges_by_ends(graph);
  geometry::EdgeGraph result;
  result.vertex_count = graph.vertex_count;
  for (const CellGraph::Edge& edge : graph.edges) result.edges.push_back({edge.start, edge.end});
  for (const CellGraph::Corners& face : graph.faces) {
    std::vector<geometry::EdgeUse>& loop = result.faces.emplace_back().loops.emplace_back();
    for (std::size_t k = 0; k < face.size(); ++k) {
      const VertexId a = face[k], b = face[(k + 1) % face.size()];
      const auto found = known.find(std::minmax(a, b));
      if (found == known.end())
        throw Error(
            ErrorCode::invalid_argument,
            fmt::format("a face of a cell goes from vertex {} to {}, but no edge does", a.value, b.value));
      loop.push_back({found->second, graph.edge(found->second).start != a});
    }
  }
  return result;
}

std::optional<EdgeId> edge_between(const CellGraph& graph, VertexId a, VertexId b) {
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    if (std::minmax(graph.edges[e].start, graph.edges[e].end) == std::minmax(a, b)) return EdgeId(e);
  return std::nullopt;
}

int non_convex_count(const CellGraph& graph) {
  return static_cast<int>(
      std::count_if(graph.edges.begin(), graph.edges.end(),
                    [](const CellGraph::Edge& edge) { return edge.kind == EdgeKind::non_convex; }));
}

}  // namespace isopatch::segmentation
