#include "geometry/brep/require_solid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/brep_graph.hpp"

namespace isopatch::geometry {
namespace {

std::string place(const Eigen::Vector3d& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

template <class IdType>
std::string listed(const Brep& brep, const std::vector<IdType>& ids) {
  constexpr std::size_t most = 3;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(most, ids.size()); ++i) texts.push_back(describe(brep, ids[i]));
  const std::string text = fmt::format("{}", fmt::join(texts, "; "));
  return ids.size() > most ? fmt::format("{}; and {} more", text, ids.size() - most) : text;
}

}  // namespace

std::string describe(const Brep& brep, EdgeId id) {
  const BrepEdge& edge = brep.edge(id);
  std::vector<int> faces;
  for (const FaceId face : edge.faces) faces.push_back(face.value);
  std::string listed = fmt::format("{}", fmt::join(faces, ", "));
  if (faces.size() > 1) listed.replace(listed.rfind(", "), 2, " and ");
  return fmt::format("edge {} from {} to {}, of {} {}", id.value, describe(brep, edge.start),
                     describe(brep, edge.end), faces.size() == 1 ? "face" : "faces", listed);
}

std::string describe(const Brep& brep, VertexId id) {
  return fmt::format("vertex {} at {} m", id.value, place(brep.vertex(id)));
}

std::string describe(const Brep& brep, FaceId id) {
  const BrepFace& face = brep.face(id);
  return face.name.empty() ? fmt::format("face {}", id.value)
                           : fmt::format("face {} '{}'", id.value, face.name);
}

std::string boundary_problem(const Brep& brep, const BoundaryReport& report) {
  const auto count = [](const auto& ids) {
    return ids.size() == 1 ? "1 edge" : fmt::format("{} edges", ids.size());
  };
  if (!report.overused_edges.empty())
    return fmt::format("the boundary is not a manifold: {} with more than two faces: {}",
                       count(report.overused_edges), listed(brep, report.overused_edges));
  if (!report.free_edges.empty())
    return fmt::format("the boundary is open: {} with one face only: {}", count(report.free_edges),
                       listed(brep, report.free_edges));
  if (!report.misoriented_edges.empty())
    return fmt::format(
        "the faces cannot be oriented: {} between a face turned outwards and one turned inwards: {}",
        count(report.misoriented_edges), listed(brep, report.misoriented_edges));
  if (!report.pinched_vertices.empty())
    return fmt::format("the boundary is not a manifold: it touches itself in {}",
                       listed(brep, report.pinched_vertices));
  return "";
}

SolidFault::Edge drawn(const Brep& brep, EdgeId edge) {
  constexpr int pieces = 24;
  SolidFault::Edge result{fmt::format("edge {}", edge.value), Eigen::Matrix3Xd(3, pieces + 1)};
  for (int i = 0; i <= pieces; ++i) result.points.col(i) = brep.point(edge, double(i) / pieces);
  return result;
}

SolidFault boundary_fault(const Brep& brep, const BoundaryReport& report) {
  SolidFault fault;
  for (const auto* edges : {&report.overused_edges, &report.free_edges, &report.misoriented_edges})
    for (const EdgeId edge : *edges) {
      fault.edges.push_back(drawn(brep, edge));
      for (const FaceId face : brep.edge(edge).faces) fault.faces.push_back({face.value});
    }
  for (const VertexId vertex : report.pinched_vertices)
    fault.points.push_back({fmt::format("vertex {}", vertex.value), brep.vertex(vertex)});
  return fault;
}

void require_solid(const Brep& brep) {
  const BoundaryReport report = boundary(edge_graph(brep));
  const std::string problem = boundary_problem(brep, report);
  if (!problem.empty()) throw SolidError(ErrorCode::not_manifold, problem, boundary_fault(brep, report));
}

}  // namespace isopatch::geometry
