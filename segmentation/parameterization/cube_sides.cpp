#include "segmentation/parameterization/internal/cube_sides.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/topology/graph_connectivity.hpp"
#include "segmentation/parameterization/internal/outline.hpp"
#include "segmentation/parameterization/internal/refused_faces.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::BrepFile;
using geometry::EdgeGraph;
using geometry::Side;
using geometry::SolidError;
using geometry::SolidFault;

std::string place_text(const Eigen::Vector3d& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
}

/// "vertices 4 (0, 0, 1) and 5 (1, 0, 1)", the lower number first.
std::string ends_of(const geometry::Brep& brep, EdgeId edge) {
  const auto [low, high] = std::minmax(brep.edge(edge).start, brep.edge(edge).end);
  return fmt::format("vertices {} {} and {} {}", low.value, place_text(brep.vertex(low)), high.value,
                     place_text(brep.vertex(high)));
}

SolidFault edge_fault(const BrepFile& solid, EdgeId edge) {
  SolidFault fault;
  for (const FaceId face : solid.brep.edge(edge).faces) fault.faces.push_back({face.value, solid.name});
  fault.edges.push_back({"edge between " + ends_of(solid.brep, edge), drawn(solid.brep, edge).points});
  return fault;
}

[[noreturn]] void refuse_edge(const BrepFile& solid, EdgeId edge, const std::string& what) {
  throw SolidError(
      ErrorCode::not_conforming,
      fmt::format("solid '{}', edge between {}: {}", solid.name, ends_of(solid.brep, edge), what),
      edge_fault(solid, edge));
}

std::vector<std::string> faces_at(const geometry::Brep& brep, EdgeId edge) {
  std::vector<std::string> names;
  for (const FaceId face : brep.edge(edge).faces) names.push_back(face_in_words(face_name(brep, face)));
  return names;
}

void check_shell(const BrepFile& solid, const geometry::BoundaryReport& boundary) {
  if (!boundary.overused_edges.empty()) {
    const EdgeId edge = boundary.overused_edges.front();
    const auto names = faces_at(solid.brep, edge);
    refuse_edge(
        solid, edge,
        fmt::format("{} faces meet here ({}); an edge has two", names.size(), fmt::join(names, ", ")));
  }
  if (!boundary.free_edges.empty()) {
    const EdgeId edge = boundary.free_edges.front();
    refuse_edge(
        solid, edge,
        fmt::format("the shell is open, only {} ends here", fmt::join(faces_at(solid.brep, edge), ", ")));
  }
  if (!boundary.misoriented_edges.empty())
    refuse_edge(solid, boundary.misoriented_edges.front(),
                "its two faces look to different sides of the shell; turn one of them around");
}

void check_cube(const BrepFile& solid, const EdgeGraph& graph, const geometry::BoundaryReport& boundary) {
  const geometry::ConnectivityReport report = connectivity(graph, topology(graph, boundary));
  if (is_cube(graph, report)) return;
  SolidFault fault;
  std::string why = "wrong counts";
  if (!report.low_degree.empty()) {
    const VertexId vertex = report.low_degree.front();
    why = fmt::format("fewer than three edges meet at vertex {}", vertex.value);
    fault.points.push_back({fmt::format("vertex {}", vertex.value), solid.brep.vertex(vertex)});
  } else if (report.conflict) {
    why = fmt::format("{} and {} meet in more than an edge",
                      face_in_words(face_name(solid.brep, report.conflict->first)),
                      face_in_words(face_name(solid.brep, report.conflict->second)));
    for (const FaceId face : {report.conflict->first, report.conflict->second})
      fault.faces.push_back({face.value, solid.name});
  }
  throw SolidError(
      ErrorCode::unsupported,
      fmt::format("solid '{}' is no topological hexahedron: {}. It has {} vertices, {} edges and {} "
                  "faces; a cube has 8, 12 and 6, connected as a cube's",
                  solid.name, why, graph.vertex_count, graph.edges.size(), graph.faces.size()),
      std::move(fault));
}

void check_edges(const BrepFile& solid) {
  const geometry::Brep& brep = solid.brep;
  for (std::size_t e = 0; e < brep.edges().size(); ++e) {
    const EdgeId edge(static_cast<int>(e));
    if (brep.edge(edge).length > 1e-9 * brep.size()) continue;
    throw SolidError(ErrorCode::invalid_argument,
                     fmt::format("{}: the edge between {} has no length; merge the two",
                                 described(solid, brep.edge(edge).faces.front()), ends_of(brep, edge)),
                     edge_fault(solid, edge));
  }
}

void check_outlines(const BrepFile& solid) {
  const geometry::Brep& brep = solid.brep;
  for (std::size_t f = 0; f < brep.faces().size(); ++f) {
    const FaceId face(static_cast<int>(f));
    std::vector<DomainCurve> loop;
    for (const geometry::EdgeUse& use : brep.face(face).loops.front())
      loop.push_back([&brep, face, use](double t) -> Eigen::Vector2d {
        return brep.domain_point(face, use, use.reversed ? 1 - t : t);
      });
    const std::optional<Eigen::Vector2d> crossing = self_intersection(loop);
    if (!crossing) continue;
    const Eigen::Vector3d place = brep.point(face, *crossing);
    throw SolidError(
        ErrorCode::invalid_argument,
        fmt::format("{}: its outline crosses itself at {}", described(solid, face), place_text(place)),
        {.faces = {{face.value, solid.name, "outline crosses itself"}}, .points = {{"crossing", place}}});
  }
}

std::set<VertexId> corners_of(const EdgeGraph& graph, FaceId face) {
  const std::vector<VertexId> around = corners(graph, graph.face(face).loops.front());
  return {around.begin(), around.end()};
}

/// The vertex at each corner, grown from the first vertex and its neighbours; the graph is a cube's.
std::array<VertexId, 8> grown_corners(const EdgeGraph& graph) {
  const VertexId origin(0);
  std::set<VertexId> neighbours;
  for (const EdgeGraph::Edge& edge : graph.edges) {
    if (edge.start == origin) neighbours.insert(edge.end);
    if (edge.end == origin) neighbours.insert(edge.start);
  }
  const std::vector<VertexId> axes(neighbours.begin(), neighbours.end());
  std::array<VertexId, 8> at;
  at[0] = origin;
  for (std::size_t d = 0; d < 3; ++d) at[std::size_t(1) << d] = axes[d];
  std::set<VertexId> rest;
  for (int v = 0; v < graph.vertex_count; ++v) rest.insert(VertexId(v));
  rest.erase(origin);
  for (const VertexId axis : axes) rest.erase(axis);
  // The fourth corner of the face through the origin and two of its neighbours.
  for (std::size_t f = 0; f < graph.faces.size(); ++f) {
    const std::set<VertexId> in = corners_of(graph, FaceId(static_cast<int>(f)));
    if (!in.contains(origin)) continue;
    std::size_t corner = 0;
    for (std::size_t d = 0; d < 3; ++d) corner += in.contains(axes[d]) ? std::size_t(1) << d : 0;
    for (const VertexId v : in)
      if (rest.contains(v)) at[corner] = v;
    rest.erase(at[corner]);
  }
  at[7] = *rest.begin();
  return at;
}

std::array<FaceId, 6> sides_at(const EdgeGraph& graph, const std::array<VertexId, 8>& at) {
  std::array<FaceId, 6> result;
  for (const Side side : geometry::all_sides) {
    std::set<VertexId> wanted;
    for (const int s : {0, 1})
      for (const int t : {0, 1})
        wanted.insert(at[static_cast<std::size_t>(geometry::side_corner(side, s, t))]);
    for (std::size_t f = 0; f < graph.faces.size(); ++f)
      if (corners_of(graph, FaceId(static_cast<int>(f))) == wanted)
        result[static_cast<std::size_t>(side)] = FaceId(static_cast<int>(f));
  }
  return result;
}

/// Whether a loop that walks with its face to the left, seen from outside, runs around a side as on a
/// right-handed cube. All loops of a shell agree on it.
bool is_right_handed(const EdgeGraph& graph, const std::array<VertexId, 8>& at, FaceId west) {
  const std::vector<VertexId> loop = corners(graph, graph.face(west).loops.front());
  const auto vertex = [&](int s, int t) {
    return at[static_cast<std::size_t>(geometry::side_corner(Side::west, s, t))];
  };
  const auto start =
      static_cast<std::size_t>(std::find(loop.begin(), loop.end(), vertex(0, 0)) - loop.begin());
  // Outside lies against direction 1: its normal is that of t and s.
  return loop[(start + 1) % 4] == vertex(0, 1);
}

}  // namespace

std::array<FaceId, 6> cube_sides(const BrepFile& solid) {
  refuse_faces(solid);
  const EdgeGraph graph = edge_graph(solid.brep);
  const geometry::BoundaryReport boundary = geometry::boundary(graph);
  check_shell(solid, boundary);
  check_cube(solid, graph, boundary);
  check_edges(solid);
  check_outlines(solid);
  const double size = solid.brep.size();
  if (!(std::abs(solid.brep.volume()) > 1e-12 * size * size * size))
    throw Error(ErrorCode::invalid_argument, fmt::format("solid '{}' has no volume", solid.name));
  std::array<VertexId, 8> at = grown_corners(graph);
  std::array<FaceId, 6> sides = sides_at(graph, at);
  if (is_right_handed(graph, at, sides[0])) return sides;
  std::swap(at[1], at[2]);
  std::swap(at[5], at[6]);
  return sides_at(graph, at);
}

std::array<VertexId, 8> cube_vertices(const geometry::Brep& brep, const std::array<FaceId, 6>& sides) {
  const EdgeGraph graph = edge_graph(brep);
  std::array<std::set<VertexId>, 6> on;
  for (std::size_t side = 0; side < 6; ++side) on[side] = corners_of(graph, sides[side]);
  std::array<VertexId, 8> at;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const auto &x = on[corner & 1], &y = on[2 + (corner >> 1 & 1)], &z = on[4 + (corner >> 2 & 1)];
    const auto found =
        std::find_if(x.begin(), x.end(), [&](VertexId v) { return y.contains(v) && z.contains(v); });
    if (found == x.end())
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("the faces of a solid that are said to be the sides of a cube have no common vertex "
                      "at corner {}",
                      corner));
    at[corner] = *found;
  }
  return at;
}

}  // namespace isopatch::segmentation
