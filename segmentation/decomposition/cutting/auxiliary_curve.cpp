#include "segmentation/decomposition/cutting/auxiliary_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/base/error.hpp"
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

}  // namespace

geometry::CellCurve curve_in_domain(const CellShapes& shapes, geometry::SurfaceId surface,
                                    const CurveEnd& from, const CurveEnd& to, double tolerance) {
  const auto on_surface = [&](double t) -> Eigen::Vector3d {
    return shapes.point(surface, from.uv + t * (to.uv - from.uv));
  };
  const Eigen::Vector3d off_from = from.point - on_surface(0), off_to = to.point - on_surface(1);
  const CurvePoints between = [&](double t) -> Eigen::Vector3d {
    return on_surface(t) + (1 - t) * off_from + t * off_to;
  };
  geometry::CellCurve curve{interpolated(between, following_knots({between}, tolerance))};
  if (std::holds_alternative<geometry::PlaneSurface>(shapes.complex().surface(surface))) return curve;
  Eigen::Matrix3Xd trace = Eigen::Matrix3Xd::Zero(3, 2);
  trace.topRows<2>() << from.uv, to.uv;
  curve.traces.push_back({surface, NurbsCurve({geometry::KnotVector()}, trace)});
  return curve;
}

std::optional<AuxiliaryCurve> auxiliary_curve(const CellShapes& shapes, FaceId id, VertexId from, VertexId to,
                                              double tolerance) {
  const geometry::CellFace& face = shapes.complex().face(id);
  Eigen::Matrix2Xd polygon = outline(shapes, id);
  if (shapes.is_turned(id)) polygon = polygon.rowwise().reverse().eval();
  const auto in_domain = [&](VertexId vertex) -> Eigen::Vector2d {
    for (const geometry::EdgeUse& use : face.loop)
      if (shapes.complex().from(use) == vertex)
        return shapes.domain_point(id, use.edge, use.reversed ? 1 : 0);
    throw Error(ErrorCode::invalid_argument, "an auxiliary curve joins vertices of the face's outline");
  };
  const Eigen::Vector2d start = in_domain(from), end = in_domain(to);
  const PolygonCorner first = corner_at(polygon, start), last = corner_at(polygon, end);
  const double angle = std::min(free_angle(first, end - start), free_angle(last, start - end));
  if (!(angle > 1e-3) || crosses_outline(polygon, first, last)) return std::nullopt;
  AuxiliaryCurve result;
  result.smallest_angle = Angle::radians(angle);
  result.curve = curve_in_domain(shapes, face.surface, {start, shapes.complex().vertex(from)},
                                 {end, shapes.complex().vertex(to)}, tolerance);
  return result;
}

}  // namespace isopatch::segmentation
