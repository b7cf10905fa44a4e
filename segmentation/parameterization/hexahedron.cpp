#include "segmentation/parameterization/internal/hexahedron.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/parameterization/internal/brep_splines.hpp"
#include "segmentation/parameterization/internal/cube_sides.hpp"
#include "segmentation/parameterization/internal/refused_faces.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::EdgeUse;
using Triangles = std::optional<geometry::Tessellation>;

/// Whether a face's domain is mapped affinely: planes, and splines that are parallelograms.
bool is_affine_face(const Brep& brep, FaceId id) {
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

/// A side of a face as an edge of its solid.
struct EdgeOfSide {
  EdgeUse use;
  bool turned = false;  ///< whether the side runs against the edge
};

/// The edge of a face between two of its corners.
EdgeOfSide edge_between(const Brep& brep, FaceId face, VertexId from, VertexId to) {
  for (const EdgeUse& use : brep.face(face).loops.front()) {
    const geometry::BrepEdge& edge = brep.edge(use.edge);
    if (edge.start == from && edge.end == to) return {use, false};
    if (edge.start == to && edge.end == from) return {use, true};
  }
  throw Error(ErrorCode::internal, "a face of a cube has no edge between two neighbouring corners");
}

SolidEdge solid_edge(const Brep& brep, const EdgeOfSide& side) {
  SolidEdge result;
  result.curve = [brep, side](double t) -> Eigen::Vector3d {
    return brep.point(side.use.edge, side.turned ? 1 - t : t);
  };
  result.knots = spline_knots(brep, side.use.edge);
  if (result.knots && side.turned) result.knots = reversed(*result.knots);
  result.exact = exact_curve(brep, side.use.edge);
  if (result.exact && side.turned) result.exact = reversed(*result.exact);
  return result;
}

/// Made when the first face asks for it.
class TriangulatedSolid {
 public:
  explicit TriangulatedSolid(Brep brep) : brep_(std::move(brep)) {}

  std::optional<DomainMesh> mesh(FaceId face, const std::array<EdgeOfSide, 4>& edges,
                                 const std::array<DomainCurve, 4>& sides) {
    if (!made_) triangulate();
    if (!triangles_) return std::nullopt;
    std::array<SidePoints, 4> points;
    for (std::size_t k = 0; k < 4; ++k) points[k] = along(edges[k]);
    return domain_mesh(triangles_->faces[static_cast<std::size_t>(face.value)], points, sides);
  }

 private:
  void triangulate() {
    made_ = true;
    try {
      triangles_ = tessellate(brep_, {.chord = 2e-4, .turn = Angle::degrees(6)});
    } catch (const Error&) {  // a face that the library cannot do: its neighbours keep their blends
    }
  }

  SidePoints along(const EdgeOfSide& side) const {
    const geometry::EdgePoints& edge = triangles_->edges[static_cast<std::size_t>(side.use.edge.value)];
    SidePoints result{edge.t, edge.points};
    if (side.turned) {
      result.t = (1 - edge.t.array()).reverse();
      result.points = edge.points.rowwise().reverse();
    }
    if (result.t.size() > 0) {
      result.t[0] = 0;
      result.t[result.t.size() - 1] = 1;
    }
    return result;
  }

  Brep brep_;
  bool made_ = false;
  Triangles triangles_;
};

/// A face of a solid in the frame of a side of the cube.
QuadFace quad_face(const Brep& brep, FaceId face, Side side, const std::array<VertexId, 8>& at,
                   const std::shared_ptr<TriangulatedSolid>& triangulated) {
  QuadFace result;
  result.name = face_name(brep, face);
  result.number = face.value;
  result.surface = [brep, face](const Eigen::Vector2d& uv) -> Eigen::Vector3d {
    return brep.point(face, uv);
  };
  result.is_affine = is_affine_face(brep, face);
  const auto edges = geometry::side_edges(side);
  std::array<EdgeOfSide, 4> found;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto ends = geometry::edge_corners(edges[k]);
    const auto vertex = [&](std::size_t end) { return at[static_cast<std::size_t>(ends[end])]; };
    found[k] = edge_between(brep, face, vertex(0), vertex(1));
    result.sides[k] = [brep, face, here = found[k]](double t) -> Eigen::Vector2d {
      return brep.domain_point(face, here.use, here.turned ? 1 - t : t);
    };
    result.edges[k] = solid_edge(brep, found[k]);
  }
  result.mesh = [triangulated, face, found, sides = result.sides] {
    return triangulated->mesh(face, found, sides);
  };
  return result;
}

}  // namespace

Hexahedron hexahedron(const geometry::BrepFile& solid, const std::array<FaceId, 6>& sides) {
  const Brep& brep = solid.brep;
  const std::array<VertexId, 8> at = cube_vertices(brep, sides);
  const auto triangulated = std::make_shared<TriangulatedSolid>(brep);
  const auto splines = spline_knots(brep);
  Hexahedron result;
  result.name = solid.name;
  result.edge_uncertainty = solid.largest_correction;
  for (std::size_t c = 0; c < 8; ++c) result.corners[c] = brep.vertex(at[c]);
  for (const Side side : geometry::all_sides) {
    const FaceId face = sides[static_cast<std::size_t>(side)];
    QuadFace& quad = result.faces[static_cast<std::size_t>(side)];
    quad = quad_face(brep, face, side, at, triangulated);
    quad.spline = splines[static_cast<std::size_t>(face.value)];
  }
  return result;
}

}  // namespace isopatch::segmentation
