#include "geometry/brep/make_brep.hpp"

#include <fmt/format.h>

#include <map>

#include "geometry/base/error.hpp"
#include "geometry/brep/edge_graph.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::geometry {
namespace {

std::string place(const Polyhedron& polyhedron, int vertex) {
  const Eigen::Vector3d p = polyhedron.vertices.col(vertex);
  return fmt::format("vertex {} at ({:.6g}, {:.6g}, {:.6g}) m", vertex, p.x(), p.y(), p.z());
}

void require_lengths(const Polyhedron& polyhedron) {
  const double size =
      (polyhedron.vertices.rowwise().maxCoeff() - polyhedron.vertices.rowwise().minCoeff()).norm();
  for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
    const std::vector<int>& face = polyhedron.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      if ((polyhedron.vertices.col(a) - polyhedron.vertices.col(b)).norm() <= 1e-9 * size)
        throw Error(ErrorCode::not_manifold,
                    fmt::format("an edge of face {} has no length: {} and {}; merge them", f,
                                place(polyhedron, a), place(polyhedron, b)));
    }
  }
}

void require_two_faces(const Polyhedron& polyhedron, const EdgeGraph& graph) {
  const BoundaryReport report = boundary(graph);
  const auto fail = [&](EdgeId id, const char* what) {
    throw Error(ErrorCode::not_manifold, fmt::format("the edge between {} and {} belongs to {}",
                                                     place(polyhedron, graph.edge(id).start.value),
                                                     place(polyhedron, graph.edge(id).end.value), what));
  };
  if (!report.overused_edges.empty()) fail(report.overused_edges.front(), "more than two faces");
  if (!report.free_edges.empty()) fail(report.free_edges.front(), "one face only");
}

}  // namespace

void validate(const SewOptions& options) {
  const auto require = [](const char* field, double value, double high) {
    if (!(value > 0 && value < high))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("{} is {}; it must lie in (0, {})", field, value, high));
  };
  require("same_point", options.same_point, 0.01);
  require("same_curve", options.same_curve, 0.02);
}

SewnBrep sew(const std::vector<TrimmedSurface>& faces, const SewOptions& options) {
  validate(options);
  if (faces.empty()) throw Error(ErrorCode::invalid_argument, "a solid needs faces");
  KernelSolid solid = brep_module().sew(faces, options);
  SewnBrep result{Brep(std::move(solid.kernel)), solid.largest_correction};
  if (!options.accept_open) require_solid(result.brep);
  return result;
}

Brep make_brep(const Polyhedron& polyhedron, const SewOptions& options) {
  validate(options);
  if (polyhedron.faces.empty()) throw Error(ErrorCode::invalid_argument, "a solid needs faces");
  const EdgeGraph graph = edge_graph(static_cast<int>(polyhedron.vertices.cols()), polyhedron.faces);
  require_lengths(polyhedron);
  if (!options.accept_open) require_two_faces(polyhedron, graph);
  Brep result(brep_module().polyhedron(polyhedron, options).kernel);
  if (!options.accept_open) require_solid(result);
  return result;
}

std::vector<TrimmedSurface> trimmed_surfaces(const Brep& brep) {
  return brep_module().trimmed_surfaces(brep.kernel());
}

Polyhedron corners(const Brep& brep) {
  const EdgeGraph graph = edge_graph(brep);
  Polyhedron result;
  result.vertices = brep.vertices();
  for (std::size_t f = 0; f < graph.faces.size(); ++f) {
    const auto& loops = graph.faces[f].loops;
    if (loops.size() != 1)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} has {} loops; a polygon has one",
                              describe(brep, FaceId(static_cast<int>(f))), loops.size()));
    std::vector<int> face;
    for (const VertexId vertex : corners(graph, loops.front())) face.push_back(vertex.value);
    if (face.size() < 3)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} has {} corners; a polygon has three at least",
                              describe(brep, FaceId(static_cast<int>(f))), face.size()));
    result.faces.push_back(std::move(face));
  }
  return result;
}

}  // namespace isopatch::geometry
