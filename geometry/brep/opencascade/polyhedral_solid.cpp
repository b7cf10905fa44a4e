#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/loop_surface.hpp"

namespace isopatch::geometry {
namespace {

class PolyhedronMaker {
 public:
  PolyhedronMaker(const Polyhedron& polyhedron, double same_point) : polyhedron_(polyhedron) {
    const Eigen::Matrix3Xd& points = polyhedron.vertices;
    const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
    scale_ = kernel_scale(size);
    tolerance_ = scale_ * same_point * size;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      TopoDS_Vertex vertex;
      builder_.MakeVertex(vertex, to_point(scale_ * points.col(i)), 1e-7);
      vertices_.push_back(vertex);
    }
  }

  ShapeInput make() {
    std::vector<TopoDS_Face> faces;
    for (std::size_t i = 0; i < polyhedron_.faces.size(); ++i) faces.push_back(face(i));
    ShapeInput input = oriented_solid(std::move(faces), 1 / scale_);
    std::vector<bool> used(vertices_.size());
    for (const auto& polygon : polyhedron_.faces)
      for (const int v : polygon) used[static_cast<std::size_t>(v)] = true;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      if (used[i]) input.vertices.push_back(vertices_[i]);
    return input;
  }

 private:
  Eigen::Vector3d corner(int vertex) const { return scale_ * polyhedron_.vertices.col(vertex); }

  TopoDS_Face face(std::size_t index) {
    const std::vector<int>& polygon = polyhedron_.faces[index];
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector3d a = corner(polygon[i]), b = corner(polygon[(i + 1) % polygon.size()]);
      centre += a / static_cast<double>(polygon.size());
      normal += (a - corner(polygon[0])).cross(b - corner(polygon[0]));
    }
    double off = 0;
    normal.normalize();
    for (const int v : polygon) off = std::max(off, std::abs((corner(v) - centre).dot(normal)));
    if (off <= tolerance_ && normal.allFinite()) return plane_face(polygon, centre, normal, off);
    if (polygon.size() == 4) return bilinear_face(polygon);
    if (const auto surface = surface_through(polygon)) return smooth_face(polygon, *surface);
    throw SolidError(
        ErrorCode::invalid_argument,
        fmt::format(
            "face {} has {} corners and is not plane: a corner lies {:.3g} m off, and no smooth surface "
            "through its edges was found; split it into triangles or quadrilaterals",
            index, polygon.size(), off / scale_),
        {.faces = {{static_cast<int>(index)}}});
  }

  TopoDS_Face plane_face(const std::vector<int>& polygon, const Eigen::Vector3d& centre,
                         const Eigen::Vector3d& normal, double off) {
    const Handle(Geom_Plane) plane =
        new Geom_Plane(to_point(centre), gp_Dir(normal.x(), normal.y(), normal.z()));
    TopoDS_Face face;
    builder_.MakeFace(face, plane, 1e-7 + off);
    builder_.Add(face, wire(polygon, off));
    return face;
  }

  // (u, v) at the corners: (0, 0), (1, 0), (1, 1), (0, 1).
  TopoDS_Face bilinear_face(const std::vector<int>& polygon) {
    Eigen::Matrix3Xd points(3, 4);
    points << corner(polygon[0]), corner(polygon[1]), corner(polygon[3]), corner(polygon[2]);
    return spline_face(polygon, NurbsSurface({KnotVector(), KnotVector()}, points),
                       {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1e-7);
  }

  // Up to 1e-7 of the size, as what OpenCASCADE takes for one point.
  std::optional<LoopSurface> surface_through(const std::vector<int>& polygon) const {
    std::vector<LoopSegment> loop;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      loop.emplace_back([a = corner(polygon[i]), b = corner(polygon[(i + 1) % polygon.size()])](double t) {
        return Eigen::Vector3d((1 - t) * a + t * b);
      });
    auto surface = loop_surface(loop, 1e-5);
    if (!surface || surface->deviation > tolerance_) return std::nullopt;
    return surface;
  }

  TopoDS_Face smooth_face(const std::vector<int>& polygon, const LoopSurface& surface) {
    std::vector<Eigen::Vector2d> at;
    for (const int v : polygon) at.push_back(surface.domain_point(corner(v)));
    const double off = 1e-7 + surface.deviation;
    for (const int v : polygon) builder_.UpdateVertex(vertices_[static_cast<std::size_t>(v)], off);
    return spline_face(polygon, surface.surface, at, off);
  }

  // @param at  the corners in the domain, where the edges are straight too
  TopoDS_Face spline_face(const std::vector<int>& polygon, const NurbsSurface& surface,
                          const std::vector<Eigen::Vector2d>& at, double off) {
    TopoDS_Face face;
    builder_.MakeFace(face, to_shape(surface, 1), 1e-7);
    TopoDS_Wire loop;
    builder_.MakeWire(loop);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t next = (i + 1) % polygon.size();
      const TopoDS_Edge side = edge(polygon[i], polygon[next]);
      const bool forward = side.Orientation() == TopAbs_FORWARD;
      const Eigen::Vector2d from = at[forward ? i : next], to = at[forward ? next : i];
      // The edge's parameter is its length.
      double first = 0, last = 0;
      BRep_Tool::Range(side, first, last);
      const double length = last - first;
      NurbsCurve curve({KnotVector(1, {0, 0, length, length})},
                       (Eigen::Matrix3Xd(3, 2) << from.x(), to.x(), from.y(), to.y(), 0, 0).finished());
      builder_.UpdateEdge(side, to_domain_curve(curve), face, off);
      builder_.Add(loop, side);
    }
    builder_.Add(face, loop);
    return face;
  }

  TopoDS_Wire wire(const std::vector<int>& polygon, double off) {
    TopoDS_Wire result;
    builder_.MakeWire(result);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const TopoDS_Edge side = edge(polygon[i], polygon[(i + 1) % polygon.size()]);
      builder_.UpdateEdge(side, 1e-7 + off);
      for (const int v : {polygon[i], polygon[(i + 1) % polygon.size()]})
        builder_.UpdateVertex(vertices_[static_cast<std::size_t>(v)], 1e-7 + off);
      builder_.Add(result, side);
    }
    return result;
  }

  // From one vertex to the other: the edge that a face before has made, reversed if it went the other way.
  TopoDS_Edge edge(int from, int to) {
    const auto [low, high] = std::minmax(from, to);
    auto [found, is_new] = edges_.try_emplace({low, high});
    if (is_new) {
      const Eigen::Vector3d a = corner(from), b = corner(to);
      const Eigen::Vector3d direction = (b - a).normalized();
      const Handle(Geom_Line) line =
          new Geom_Line(to_point(a), gp_Dir(direction.x(), direction.y(), direction.z()));
      TopoDS_Edge made;
      builder_.MakeEdge(made, line, 1e-7);
      builder_.Add(made, vertices_[static_cast<std::size_t>(from)].Oriented(TopAbs_FORWARD));
      builder_.Add(made, vertices_[static_cast<std::size_t>(to)].Oriented(TopAbs_REVERSED));
      builder_.Range(made, 0, (b - a).norm());
      found->second = {made, from};
    }
    const auto& [made, start] = found->second;
    return TopoDS::Edge(made.Oriented(start == from ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  const Polyhedron& polyhedron_;
  BRep_Builder builder_;
  double scale_ = 1, tolerance_ = 0;
  std::vector<TopoDS_Vertex> vertices_;
  std::map<std::pair<int, int>, std::pair<TopoDS_Edge, int>> edges_;
};

}  // namespace

KernelSolid polyhedral_solid(const Polyhedron& polyhedron, const SewOptions& options) {
  return {std::make_shared<ShapeKernel>(PolyhedronMaker(polyhedron, options.same_point).make()), "", 0};
}

}  // namespace isopatch::geometry
