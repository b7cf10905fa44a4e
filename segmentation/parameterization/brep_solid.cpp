#include "segmentation/parameterization/brep_solid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "geometry/brep/solid_error.hpp"
#include "segmentation/parameterization/brep_splines.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::BrepEdge;
using geometry::BrepFace;

std::string name_of(const Brep& brep, FaceId id) {
  const BrepFace& face = brep.face(id);
  return face.name.empty() ? fmt::format("face {}", id.value) : face.name;
}

/// "solid 'shaft', face 2 (cylinder)".
std::string described(const Brep& brep, FaceId id, const std::string& solid) {
  return fmt::format("solid '{}', {} ({})", solid, face_in_words(name_of(brep, id)),
                     name(brep.face(id).kind));
}

/// What the whole solid has; a cube has 8, 12 and 6.
std::string counted(const Brep& brep) {
  return fmt::format("The solid has {} vertices, {} edges and {} faces; a hexahedron has 8, 12 and 6",
                     brep.vertices().cols(), brep.edges().size(), brep.faces().size());
}

std::string millimetres(const Eigen::Vector3d& point) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * point[0], 1e3 * point[1], 1e3 * point[2]);
}

geometry::SolidFault fault_at(FaceId face, const std::string& solid, const std::string& remark,
                              const Brep& brep, const std::vector<geometry::EdgeUse>& edges) {
  geometry::SolidFault fault{.faces = {{face.value, solid, remark}}};
  for (const geometry::EdgeUse& use : edges) {
    constexpr int pieces = 24;
    Eigen::Matrix3Xd points(3, pieces + 1);
    for (int i = 0; i <= pieces; ++i) points.col(i) = brep.point(use.edge, double(i) / pieces);
    fault.edges.push_back({fmt::format("edge {}", use.edge.value), points});
  }
  return fault;
}

bool is_round(geometry::SurfaceKind kind) {
  using geometry::SurfaceKind;
  return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || kind == SurfaceKind::sphere ||
         kind == SurfaceKind::torus;
}

std::string advice_on_cutting(geometry::SurfaceKind kind) {
  if (is_round(kind)) return "cut the solid along its axis, into pieces with four edges on each face";
  return "cut the solid across it, into pieces with four edges on each face";
}

/// A face that goes all around: its loop walks an edge in both directions.
void refuse_seam(const Brep& brep, FaceId id, const std::string& solid) {
  for (const auto& loop : brep.face(id).loops)
    for (const geometry::EdgeUse& use : loop) {
      if (std::find(loop.begin(), loop.end(), geometry::EdgeUse{use.edge, !use.reversed}) == loop.end())
        continue;
      const BrepEdge& seam = brep.edge(use.edge);
      throw geometry::SolidError(
          ErrorCode::unsupported,
          fmt::format("{} is closed on itself: it goes all around and meets itself along the edge from {} to "
                      "{}; {}. {}",
                      described(brep, id, solid), millimetres(brep.vertex(seam.start)),
                      millimetres(brep.vertex(seam.end)), advice_on_cutting(brep.face(id).kind),
                      counted(brep)),
          fault_at(id, solid, "closed on itself", brep, {use}));
    }
}

void refuse_inner_loops(const Brep& brep, FaceId id, const std::string& solid) {
  const auto& loops = brep.face(id).loops;
  if (loops.size() == 1) return;
  if (loops.empty())
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format("{} has no edges, it is closed on itself; {}. {}", described(brep, id, solid),
                    advice_on_cutting(brep.face(id).kind), counted(brep)),
        fault_at(id, solid, "no edges", brep, {}));
  std::vector<geometry::EdgeUse> inner;
  for (std::size_t i = 1; i < loops.size(); ++i) inner.insert(inner.end(), loops[i].begin(), loops[i].end());
  const std::size_t holes = loops.size() - 1;
  throw geometry::SolidError(
      ErrorCode::unsupported,
      fmt::format(
          "{} has {} hole{} ({} outlines); each face of a hexahedron has one outline with four edges. "
          "Cut the solid through the hole{} first. {}",
          described(brep, id, solid), holes, holes == 1 ? "" : "s", loops.size(), holes == 1 ? "" : "s",
          counted(brep)),
      fault_at(id, solid, fmt::format("{} outlines", loops.size()), brep, inner));
}

void refuse_closed_edges(const Brep& brep, FaceId id, const std::string& solid) {
  for (const geometry::EdgeUse& use : brep.face(id).loops.front()) {
    const BrepEdge& edge = brep.edge(use.edge);
    if (edge.start != edge.end) continue;
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format(
            "{} is bounded by an edge that is closed on itself ({}, through {}); each face of a "
            "hexahedron has four edges from corner to corner. Cut the solid through the middle of that "
            "face, twice. {}",
            described(brep, id, solid), name(edge.kind), millimetres(brep.vertex(edge.start)), counted(brep)),
        fault_at(id, solid, "a closed edge", brep, {use}));
  }
}

SolidEdge solid_edge(const Brep& brep, const geometry::EdgeUse& use) {
  SolidEdge result;
  result.curve = [brep, use](double t) -> Eigen::Vector3d {
    return brep.point(use.edge, use.reversed ? 1 - t : t);
  };
  result.knots = spline_knots(brep, use.edge);
  if (result.knots && use.reversed) result.knots = reversed(*result.knots);
  return result;
}

/// Whether a face's domain is mapped affinely: planes, and splines that are parallelograms.
bool is_affine(const Brep& brep, FaceId id) {
  using geometry::SurfaceKind;
  const SurfaceKind kind = brep.face(id).kind;
  if (kind == SurfaceKind::plane) return true;
  if (kind != SurfaceKind::spline && kind != SurfaceKind::other) return false;
  const geometry::DomainBox box = brep.domain(id);
  const auto at = [&](double s, double t) {
    return brep.point(id, box.low + Eigen::Vector2d(s, t).cwiseProduct(box.high - box.low));
  };
  const Eigen::Vector3d origin = at(0, 0), along = at(1, 0) - origin, across = at(0, 1) - origin;
  for (const double s : {0.0, 0.3, 0.5, 0.8, 1.0})
    for (const double t : {0.0, 0.2, 0.6, 1.0})
      if (!((at(s, t) - (origin + s * along + t * across)).norm() <= 1e-12 * brep.size())) return false;
  return true;
}

SolidFace solid_face(const Brep& brep, FaceId id) {
  const BrepFace& face = brep.face(id);
  SolidFace result;
  result.name = name_of(brep, id);
  if (face.colour) result.colour = geometry::hex_text(*face.colour);
  for (const geometry::EdgeUse& use : face.loops.front()) {
    const BrepEdge& edge = brep.edge(use.edge);
    result.corners.push_back((use.reversed ? edge.end : edge.start).value);
    result.curves.push_back([brep, id, use](double t) -> Eigen::Vector2d {
      return brep.domain_point(id, use, use.reversed ? 1 - t : t);
    });
    result.edges.push_back(solid_edge(brep, use));
  }
  result.surface = [brep, id](const Eigen::Vector2d& uv) -> Eigen::Vector3d { return brep.point(id, uv); };
  result.is_affine = is_affine(brep, id);
  return result;
}

}  // namespace

HexSolid hex_solid(const Brep& brep, const std::string& name, double edge_uncertainty) {
  HexSolid result;
  result.name = name;
  result.has_outward_loops = true;
  result.edge_uncertainty = edge_uncertainty;
  for (const auto& vertex : brep.vertices().colwise()) result.vertices.emplace_back(vertex);
  const int count = static_cast<int>(brep.faces().size());
  for (int f = 0; f < count; ++f) refuse_seam(brep, FaceId(f), name);
  for (int f = 0; f < count; ++f) refuse_inner_loops(brep, FaceId(f), name);
  for (int f = 0; f < count; ++f) refuse_closed_edges(brep, FaceId(f), name);
  for (int f = 0; f < count; ++f) result.faces.push_back(solid_face(brep, FaceId(f)));
  const auto splines = spline_knots(brep);
  for (std::size_t f = 0; f < splines.size(); ++f) result.faces[f].spline = splines[f];
  return result;
}

}  // namespace isopatch::segmentation
