#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/base/ids.hpp"
#include "geometry/splines/nurbs.hpp"
#include "geometry/topology/edge_use.hpp"

namespace isopatch::geometry {

using CurveId = Id<struct CellCurveTag>;
using SurfaceId = Id<struct CellSurfaceTag>;
using CellId = Id<struct CellTag>;

/// A plane by a point, m, and two unit directions at right angles. Its domain is (x, y), m.
struct PlaneSurface {
  Eigen::Vector3d origin, x, y;
  Eigen::Vector3d normal() const { return x.cross(y); }
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return origin + uv[0] * x + uv[1] * y; }
  Eigen::Vector2d domain_point(const Eigen::Vector3d& p) const {
    return {(p - origin).dot(x), (p - origin).dot(y)};
  }
};

/// A surface that faces are pieces of: that of a face of the source solid, or a new one, m.
using CellSurface = std::variant<FaceId, PlaneSurface, NurbsSurface>;

/// A curve that edges are pieces of, over t in [0, 1].
struct CellCurve {
  std::variant<EdgeId, NurbsCurve> shape;  ///< an edge of the source solid, or a new curve over [0, 1], m
  /// The curve (u, v, 0) over [0, 1] in a surface's domain.
  struct Trace {
    SurfaceId surface;
    NurbsCurve domain;
  };
  /// On surfaces for which it does not follow: it does for a plane, and for an edge of the source on its own
  /// faces.
  std::vector<Trace> traces = {};
};

/// A piece of a curve, from its parameter `low` to `high`, low < high.
struct CellEdge {
  CurveId curve;
  double low = 0, high = 1;
  VertexId start, end;
};

/// A piece of a surface with one closed outline.
struct CellFace {
  SurfaceId surface;
  /// The face to the left, seen from its front: outside the source solid on its faces, where the normal
  /// points on others.
  std::vector<EdgeUse> loop;
  std::optional<FaceId> origin = {};  ///< the face of the source solid that it is a part of
};

/// A face as part of a cell's boundary.
struct CellFaceUse {
  FaceId face;
  bool reversed = false;  ///< its front looks into the cell
  /// Faces of one number continue each other, without an edge between them: they are one side of the cell.
  int side = 0;
  bool operator==(const CellFaceUse&) const = default;
};

/// A part of the solid: a ball with faces that are discs.
struct Cell {
  std::vector<CellFaceUse> faces;
};

/// A solid divided into cells, which share faces, edges and vertices: each is stored once. Plain data that
/// refers to the edges and faces of the source solid. FaceId, EdgeId and VertexId count those of the complex
/// but where the source is named.
struct CellComplex {
  std::vector<CellCurve> curves;
  std::vector<CellSurface> surfaces;
  std::vector<Eigen::Vector3d> vertices;  ///< m
  std::vector<CellEdge> edges;
  std::vector<CellFace> faces;
  std::vector<Cell> cells;

  const CellCurve& curve(CurveId id) const { return curves[static_cast<std::size_t>(id.value)]; }
  const CellSurface& surface(SurfaceId id) const { return surfaces[static_cast<std::size_t>(id.value)]; }
  const Eigen::Vector3d& vertex(VertexId id) const { return vertices[static_cast<std::size_t>(id.value)]; }
  const CellEdge& edge(EdgeId id) const { return edges[static_cast<std::size_t>(id.value)]; }
  const CellFace& face(FaceId id) const { return faces[static_cast<std::size_t>(id.value)]; }
  const Cell& cell(CellId id) const { return cells[static_cast<std::size_t>(id.value)]; }
  VertexId from(EdgeUse use) const { return use.reversed ? edge(use.edge).end : edge(use.edge).start; }
  VertexId to(EdgeUse use) const { return use.reversed ? edge(use.edge).start : edge(use.edge).end; }

  VertexId add_vertex(const Eigen::Vector3d& place);
  CurveId add_curve(CellCurve curve);
  SurfaceId add_surface(CellSurface surface);
  FaceId add_face(CellFace face);
  /// The whole of a new curve.
  EdgeId add_edge(CellCurve curve, VertexId from, VertexId to);
  EdgeId add_straight_edge(VertexId from, VertexId to);
  /// @param domain  where the edge's curve is on the surface, run through as the edge is used
  void add_trace(EdgeUse use, SurfaceId surface, NurbsCurve domain);
};

}  // namespace isopatch::geometry
