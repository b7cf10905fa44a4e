#include "segmentation/decomposition/cutting/auxiliary_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "segmentation/decomposition/cutting/inside.hpp"
#include "segmentation/decomposition/cutting/spline_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::NurbsCurve;

double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Angle from a to b counter-clockwise, in [0, 360) degrees.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double angle = std::atan2(area(a, b), a.dot(b));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// A vertex of the outline's polygon, and its neighbours.
struct PolygonCorner {
  Eigen::Index at;
  Eigen::Vector2d point, before, after;
};

PolygonCorner corner_at(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& point) {
  PolygonCorner corner{};
  (polygon.colwise() - point).colwise().squaredNorm().minCoeff(&corner.at);
  const Eigen::Index n = polygon.cols();
  corner.point = polygon.col(corner.at);
  corner.before = polygon.col((corner.at + n - 1) % n);
  corner.after = polygon.col((corner.at + 1) % n);
  return corner;
}

/// The smaller of the angles that a way from a corner leaves to both sides, 0 where it leaves the polygon;
/// counter-clockwise.
double free_angle(const PolygonCorner& corner, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d after = corner.after - corner.point, before = corner.before - corner.point;
  const double whole = turn(after, before), here = turn(after, direction);
  return here < whole ? std::min(here, whole - here) : 0;
}

/// Whether segments a b and c d meet, ends included.
bool meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
          const Eigen::Vector2d& d) {
  const double slack = 1e-9 * (b - a).squaredNorm();
  const auto side = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
    const double value = area(q - p, r - p);
    return value > slack ? 1 : value < -slack ? -1 : 0;
  };
  if (side(a, b, c) * side(a, b, d) > 0 || side(c, d, a) * side(c, d, b) > 0) return false;
  if (side(a, b, c) != 0 || side(a, b, d) != 0) return true;
  const double length = (b - a).squaredNorm();  // all on one line
  const double at_c = (c - a).dot(b - a) / length, at_d = (d - a).dot(b - a) / length;
  return std::max(at_c, at_d) >= 0 && std::min(at_c, at_d) <= 1;
}

bool crosses_outline(const Eigen::Matrix2Xd& polygon, const PolygonCorner& from, const PolygonCorner& to) {
  const Eigen::Index n = polygon.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index next = (i + 1) % n;
    if (i == from.at || next == from.at || i == to.at || next == to.at) continue;
    if (meet(from.point, to.point, polygon.col(i), polygon.col(next))) return true;
  }
  return false;
}

/// The curve on a surface along a path in its domain, over [0, 1].
geometry::CellCurve curve_along(const CellShapes& shapes, geometry::SurfaceId surface, const NurbsCurve& path,
                                const CurveEnd& from, const CurveEnd& to, double tolerance) {
  const auto on_surface = [&](double t) -> Eigen::Vector3d {
    return shapes.point(surface, path.point(geometry::Parameter<1>(t)).head<2>());
  };
  const Eigen::Vector3d off_from = from.point - on_surface(0), off_to = to.point - on_surface(1);
  const CurvePoints between = [&](double t) -> Eigen::Vector3d {
    return on_surface(t) + (1 - t) * off_from + t * off_to;
  };
  geometry::CellCurve curve{interpolated(between, following_knots({between}, tolerance))};
  if (!std::holds_alternative<geometry::PlaneSurface>(shapes.complex().surface(surface)))
    curve.traces.push_back({surface, path});
  return curve;
}

/// A face's outline in its domain, counter-clockwise, with two of its vertices.
struct FaceToCross {
  Eigen::Matrix2Xd polygon;
  PolygonCorner first{}, last{};
  CurveEnd from, to;

  FaceToCross(const CellShapes& shapes, FaceId id, VertexId start, VertexId end)
      : polygon(outline(shapes, id)),
        from{in_domain(shapes, id, start), shapes.complex().vertex(start)},
        to{in_domain(shapes, id, end), shapes.complex().vertex(end)} {
    if (shapes.is_turned(id)) polygon = polygon.rowwise().reverse().eval();
    first = corner_at(polygon, from.uv);
    last = corner_at(polygon, to.uv);
  }

 private:
  static Eigen::Vector2d in_domain(const CellShapes& shapes, FaceId id, VertexId vertex) {
    for (const geometry::EdgeUse& use : shapes.complex().face(id).loop)
      if (shapes.complex().from(use) == vertex)
        return shapes.domain_point(id, use.edge, use.reversed ? 1 : 0);
    throw Error(ErrorCode::invalid_argument, "an auxiliary curve joins vertices of the face's outline");
  }
};

/// How well a curve keeps away from the outline: the least sine of the angles, as seen from its nearer
/// end, between its points and what of the outline is nearest to them; less for detours, 0 outside.
double clearance(const FaceToCross& face, const NurbsCurve& path) {
  constexpr int pieces = 24;
  double least = 1, length = 0;
  Eigen::Vector2d before = face.from.uv;
  for (int i = 1; i <= pieces; ++i) {
    const Eigen::Vector2d p = path.point(geometry::Parameter<1>(double(i) / pieces)).head<2>();
    length += (p - before).norm();
    before = p;
    if (i == pieces) break;
    if (!is_inside(face.polygon, p)) return 0;
    least = std::min(
        least, distance_to(face.polygon, p) / std::min((p - face.from.uv).norm(), (p - face.to.uv).norm()));
  }
  return least * (face.to.uv - face.from.uv).norm() / length;
}

/// The cubic whose inner control points are one.
NurbsCurve bow(const Eigen::Vector2d& from, const Eigen::Vector2d& by, const Eigen::Vector2d& to) {
  Eigen::Matrix3Xd control = Eigen::Matrix3Xd::Zero(3, 4);
  control.topRows<2>() << from, by, by, to;
  return NurbsCurve({geometry::KnotVector::bezier(3)}, control);
}

/// The plane that a curve lies in which is straight in the domain; nothing for a straight one.
std::optional<geometry::PlaneSurface> plane_of_path(const CellShapes& shapes, geometry::SurfaceId surface,
                                                    const CurveEnd& from, const CurveEnd& to,
                                                    double tolerance) {
  const auto at = [&](double t) -> Eigen::Vector3d {
    return shapes.point(surface, from.uv + t * (to.uv - from.uv));
  };
  geometry::PlaneSurface plane;
  plane.origin = at(0);
  const Eigen::Vector3d middle = at(0.5) - plane.origin, end = at(1) - plane.origin;
  const Eigen::Vector3d normal = middle.cross(end);
  if (!(normal.norm() > 1e-6 * middle.norm() * end.norm())) return std::nullopt;
  plane.x = middle.normalized();
  plane.y = normal.cross(middle).normalized();
  for (const double t : {0.1, 0.23, 0.37, 0.68, 0.81, 0.94})
    if (!(std::abs(plane.normal().dot(at(t) - plane.origin)) <= tolerance)) return std::nullopt;
  return plane;
}

}  // namespace

geometry::CellCurve curve_in_domain(const CellShapes& shapes, geometry::SurfaceId surface,
                                    const CurveEnd& from, const CurveEnd& to, double tolerance) {
  if (const auto plane = plane_of_path(shapes, surface, from, to, tolerance))
    if (auto arc = arc_on_surface(shapes, surface, *plane, from, (from.uv + to.uv) / 2, to, tolerance))
      return std::move(*arc);
  const NurbsCurve path = geometry::segment({from.uv[0], from.uv[1], 0}, {to.uv[0], to.uv[1], 0});
  return curve_along(shapes, surface, path, from, to, tolerance);
}

std::optional<AuxiliaryCurve> auxiliary_curve(const CellShapes& shapes, FaceId id, VertexId from, VertexId to,
                                              double tolerance) {
  const FaceToCross face(shapes, id, from, to);
  const Eigen::Vector2d way = face.to.uv - face.from.uv;
  const double angle = std::min(free_angle(face.first, way), free_angle(face.last, -way));
  if (!(angle > 1e-3) || crosses_outline(face.polygon, face.first, face.last)) return std::nullopt;
  return AuxiliaryCurve{
      curve_in_domain(shapes, shapes.complex().face(id).surface, face.from, face.to, tolerance),
      Angle::radians(angle)};
}

std::optional<AuxiliaryCurve> section_curve(const CellShapes& shapes, FaceId id, VertexId from, VertexId to,
                                            const geometry::PlaneSurface& plane, double tolerance) {
  const FaceToCross face(shapes, id, from, to);
  auto arc = arc_on_surface(shapes, shapes.complex().face(id).surface, plane, face.from,
                            (face.from.uv + face.to.uv) / 2, face.to, tolerance);
  if (!arc) return std::nullopt;
  const NurbsCurve& path = arc->traces.front().domain;
  const auto ahead = [&](double t) -> Eigen::Vector2d {
    return path.jacobian(geometry::Parameter<1>(t)).head<2>();
  };
  const double angle = std::min(free_angle(face.first, ahead(0)), free_angle(face.last, -ahead(1)));
  if (!(angle > 1e-3) || !(clearance(face, path) > 1e-3)) return std::nullopt;
  return AuxiliaryCurve{std::move(*arc), Angle::radians(angle)};
}

std::optional<AuxiliaryCurve> bent_curve(const CellShapes& shapes, FaceId id, VertexId from, VertexId to,
                                         double tolerance) {
  const FaceToCross face(shapes, id, from, to);
  double best = 0;
  Eigen::Vector2d through = face.from.uv;
  const Eigen::Matrix2Xd tried = points_inside(face.polygon);
  for (const auto& by : tried.colwise())
    if (const double here = clearance(face, bow(face.from.uv, by, face.to.uv)); here > best) {
      best = here;
      through = by;
    }
  if (!(best > 1e-3)) return std::nullopt;
  const double angle =
      std::min(free_angle(face.first, through - face.from.uv), free_angle(face.last, through - face.to.uv));
  if (!(angle > 1e-3)) return std::nullopt;
  return AuxiliaryCurve{curve_along(shapes, shapes.complex().face(id).surface,
                                    bow(face.from.uv, through, face.to.uv), face.from, face.to, tolerance),
                        Angle::radians(angle)};
}

}  // namespace isopatch::segmentation
