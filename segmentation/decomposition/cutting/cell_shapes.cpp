#include "segmentation/decomposition/cutting/cell_shapes.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {

using geometry::CellCurve;
using geometry::CellEdge;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::Parameter;
using geometry::PlaneSurface;
using geometry::SurfaceId;

Eigen::Vector3d CellShapes::point(EdgeId id, double t) const {
  const CellEdge& edge = complex_.edge(id);
  const double at = curve_parameter(edge, t);
  const auto& shape = complex_.curve(edge.curve).shape;
  if (const auto* source = std::get_if<EdgeId>(&shape)) return source_.point(*source, at);
  return std::get<NurbsCurve>(shape).point(Parameter<1>(at));
}

Eigen::Vector3d CellShapes::tangent(EdgeId id, double t) const {
  const CellEdge& edge = complex_.edge(id);
  const double at = curve_parameter(edge, t), pace = edge.high - edge.low;
  const auto& shape = complex_.curve(edge.curve).shape;
  if (const auto* source = std::get_if<EdgeId>(&shape)) return pace * source_.tangent(*source, at);
  return pace * std::get<NurbsCurve>(shape).jacobian(Parameter<1>(at));
}

Eigen::Vector3d CellShapes::point(SurfaceId id, const Eigen::Vector2d& uv) const {
  const geometry::CellSurface& surface = complex_.surface(id);
  if (const auto* face = std::get_if<FaceId>(&surface)) return source_.point(*face, uv);
  if (const auto* plane = std::get_if<PlaneSurface>(&surface)) return plane->point(uv);
  return std::get<NurbsSurface>(surface).point(uv);
}

Eigen::Vector3d CellShapes::normal(FaceId id, const Eigen::Vector2d& uv) const {
  const geometry::CellSurface& surface = complex_.surface(complex_.face(id).surface);
  if (const auto* face = std::get_if<FaceId>(&surface)) return source_.outward_normal(*face, uv);
  if (const auto* plane = std::get_if<PlaneSurface>(&surface)) return plane->normal();
  const auto derivatives = std::get<NurbsSurface>(surface).jacobian(uv);
  return derivatives.col(0).cross(derivatives.col(1)).normalized();
}

Eigen::Vector2d CellShapes::domain_point(FaceId face, EdgeId id, double t) const {
  const CellEdge& edge = complex_.edge(id);
  const CellCurve& curve = complex_.curve(edge.curve);
  const SurfaceId on = complex_.face(face).surface;
  const double at = curve_parameter(edge, t);
  for (const CellCurve::Trace& trace : curve.traces)
    if (trace.surface == on) return trace.domain.point(Parameter<1>(at)).head<2>();
  const geometry::CellSurface& surface = complex_.surface(on);
  if (const auto* plane = std::get_if<PlaneSurface>(&surface)) return plane->domain_point(point(id, t));
  if (const auto* origin = std::get_if<FaceId>(&surface); origin != nullptr)
    if (const auto* source = std::get_if<EdgeId>(&curve.shape))
      for (const geometry::EdgeUse& use : source_.face(*origin).loops.front())
        if (use.edge == *source) return source_.domain_point(*origin, use, at);
  if (is_plane(on)) return plane_point(std::get<FaceId>(surface), point(id, t));
  throw Error(ErrorCode::internal, "an edge has no curve in the domain of its face");
}

Eigen::Vector2d CellShapes::plane_point(FaceId face, const Eigen::Vector3d& point) const {
  const Eigen::Vector2d start = source_.domain(face).low;
  const Eigen::Matrix<double, 3, 2> axes = source_.derivatives(face, start);
  return start +
         (axes.transpose() * axes).inverse() * axes.transpose() * (point - source_.point(face, start));
}

bool CellShapes::is_plane(SurfaceId id) const {
  const geometry::CellSurface& surface = complex_.surface(id);
  if (const auto* face = std::get_if<FaceId>(&surface))
    return source_.face(*face).kind == geometry::SurfaceKind::plane;
  return std::holds_alternative<PlaneSurface>(surface);
}

bool CellShapes::is_turned(FaceId face) const {
  const auto* origin = std::get_if<FaceId>(&complex_.surface(complex_.face(face).surface));
  return origin != nullptr && source_.face(*origin).reversed;
}

bool CellShapes::is_straight(EdgeId id) const {
  const auto& shape = complex_.curve(complex_.edge(id).curve).shape;
  if (const auto* source = std::get_if<EdgeId>(&shape))
    return source_.edge(*source).kind == geometry::CurveKind::line;
  return std::get<NurbsCurve>(shape).size() == 2;
}

bool CellShapes::is_arc(EdgeId id) const {
  const auto& shape = complex_.curve(complex_.edge(id).curve).shape;
  if (const auto* source = std::get_if<EdgeId>(&shape))
    return source_.edge(*source).kind == geometry::CurveKind::circle ||
           source_.edge(*source).kind == geometry::CurveKind::ellipse;
  return std::get<NurbsCurve>(shape).is_rational();
}

Eigen::Matrix2Xd outline(const CellShapes& shapes, FaceId id, int pieces) {
  const geometry::CellFace& face = shapes.complex().face(id);
  const bool plane = shapes.is_plane(face.surface);
  std::vector<Eigen::Vector2d> points;
  for (const geometry::EdgeUse& use : face.loop) {
    const int count = plane && shapes.is_straight(use.edge) ? 1 : pieces;
    for (int i = 0; i < count; ++i) {
      const double t = double(i) / count;
      points.push_back(shapes.domain_point(id, use.edge, use.reversed ? 1 - t : t));
    }
  }
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = points[i];
  return result;
}

Angle inner_angle(const CellShapes& shapes, geometry::CellFaceUse first, geometry::CellFaceUse second,
                  geometry::EdgeUse use, double t) {
  const auto outward = [&](const geometry::CellFaceUse& face) -> Eigen::Vector3d {
    const Eigen::Vector3d front = shapes.normal(face.face, shapes.domain_point(face.face, use.edge, t));
    return face.reversed ? Eigen::Vector3d(-front) : front;
  };
  const Eigen::Vector3d one = outward(first), two = outward(second);
  Eigen::Vector3d along = shapes.tangent(use.edge, t).normalized();
  if (use.reversed) along = -along;
  return Angle::radians(std::numbers::pi - std::atan2(one.cross(two).dot(along), one.dot(two)));
}

}  // namespace isopatch::segmentation
