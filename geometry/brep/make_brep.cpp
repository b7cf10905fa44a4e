#include "geometry/brep/make_brep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/topology/edge_graph.hpp"

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
        throw SolidError(ErrorCode::not_manifold,
                         fmt::format("an edge of face {} has no length: {} and {}; merge them", f,
                                     place(polyhedron, a), place(polyhedron, b)),
                         {.faces = {{static_cast<int>(f)}},
                          .points = {{fmt::format("vertices {} and {}", a, b), polyhedron.vertices.col(a)}}});
    }
  }
}

void require_two_faces(const Polyhedron& polyhedron, const EdgeGraph& graph) {
  const BoundaryReport report = boundary(graph);
  const auto uses = places(graph);
  const auto fail = [&](const std::vector<EdgeId>& edges, const char* what) {
    SolidFault fault;
    std::vector<int> first_faces;
    for (const EdgeId id : edges) {
      const int a = graph.edge(id).start.value, b = graph.edge(id).end.value;
      Eigen::Matrix3Xd line(3, 2);
      line << polyhedron.vertices.col(a), polyhedron.vertices.col(b);
      fault.edges.push_back({fmt::format("edge between vertices {} and {}", a, b), line});
      for (const EdgeGraph::Place& use : uses[static_cast<std::size_t>(id.value)]) {
        fault.faces.push_back({use.face.value});
        if (id == edges.front()) first_faces.push_back(use.face.value);
      }
    }
    const auto& edge = graph.edge(edges.front());
    throw SolidError(
        ErrorCode::not_manifold,
        fmt::format("the edge between {} and {} belongs to {}: {} {}{}", place(polyhedron, edge.start.value),
                    place(polyhedron, edge.end.value), what, first_faces.size() == 1 ? "face" : "faces",
                    fmt::join(first_faces, " and "),
                    edges.size() > 1 ? fmt::format("; {} more such edges", edges.size() - 1) : ""),
        std::move(fault));
  };
  if (!report.overused_edges.empty()) fail(report.overused_edges, "more than two faces");
  if (!report.free_edges.empty()) fail(report.free_edges, "one face only");
}

// Where two segments of a plane cross inside both.
std::optional<Eigen::Vector2d> crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                        const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  const auto area = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const double turn = area(b - a, d - c);
  if (turn == 0) return std::nullopt;
  const double s = area(c - a, d - c) / turn, t = area(c - a, b - a) / turn;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
  return a + s * (b - a);
}

/// Where the outline of a plane polygon crosses itself, if it is plane and does.
std::optional<Eigen::Vector3d> self_crossing(const Eigen::Matrix3Xd& corners, double same_point) {
  const Eigen::Vector3d centre = corners.rowwise().mean();
  const Eigen::Matrix3Xd arms = corners.colwise() - centre;
  const Eigen::Matrix3d axes = principal_axes(arms * arms.transpose()).axes;
  const Eigen::Vector3d normal = axes.col(0);
  if (corners.cols() > 3 && (normal.transpose() * arms).norm() > same_point) return std::nullopt;
  const Eigen::Matrix<double, 3, 2> plane = axes.rightCols<2>();
  const Eigen::Matrix2Xd flat = plane.transpose() * arms;
  const Eigen::Index n = flat.cols();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (const auto at = crossing(flat.col(i), flat.col(i + 1), flat.col(j), flat.col((j + 1) % n)))
        return centre + plane * *at;
    }
  return std::nullopt;
}

void require_simple_outlines(const Polyhedron& polyhedron, double same_point) {
  const double size =
      (polyhedron.vertices.rowwise().maxCoeff() - polyhedron.vertices.rowwise().minCoeff()).norm();
  for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
    const std::vector<int>& face = polyhedron.faces[f];
    auto at = self_crossing(polyhedron.vertices(Eigen::all, face), same_point * size);
    if (!at) continue;
    for (double& x : *at)
      if (std::abs(x) < 1e-12 * size) x = 0;
    throw SolidError(ErrorCode::invalid_argument,
                     fmt::format("the outline of face {} with the vertices {} crosses itself at ({:.6g}, "
                                 "{:.6g}, {:.6g}) m; put its vertices into their order around the face",
                                 f, fmt::join(face, ", "), at->x(), at->y(), at->z()),
                     {.faces = {{static_cast<int>(f)}}, .points = {{"crossing", *at}}});
  }
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
  require_simple_outlines(polyhedron, options.same_point);
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
