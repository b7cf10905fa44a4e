#include "geometry/loop_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "geometry/base/larger.hpp"
#include "geometry/smooth_surface.hpp"

namespace isopatch::geometry {
namespace {

constexpr int degree = 3;

/// `pieces` points a curve, the first `offset` pieces after its start.
Eigen::Matrix3Xd points_of(const std::vector<LoopSegment>& loop, int pieces, double offset) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(loop.size()) * pieces);
  Eigen::Index k = 0;
  for (const LoopSegment& curve : loop)
    for (int i = 0; i < pieces; ++i) points.col(k++) = curve((i + offset) / pieces);
  return points;
}

/// The plane of a loop, by its vector area; nothing where that vanishes.
std::optional<LoopSurface> plane_of(const Eigen::Matrix3Xd& points) {
  LoopSurface result{NurbsSurface({KnotVector(), KnotVector()}, Eigen::Matrix3Xd::Zero(3, 4)), {}, {}, {}};
  result.origin = points.rowwise().mean();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Index n = points.cols();
  for (Eigen::Index i = 0; i < n; ++i)
    normal += (points.col(i) - result.origin).cross(points.col((i + 1) % n) - result.origin);
  if (!(normal.norm() > 0)) return std::nullopt;
  normal.normalize();
  result.x = (points.col(1) - points.col(0)).cross(normal).cross(normal);
  if (!(result.x.norm() > 1e-9 * (points.col(1) - points.col(0)).norm())) result.x = normal.unitOrthogonal();
  result.x = -result.x.normalized();
  result.y = normal.cross(result.x);
  return result;
}

Eigen::Matrix2Xd seen_from_above(const LoopSurface& plane, const Eigen::Matrix3Xd& points) {
  Eigen::Matrix2Xd result(2, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) result.col(i) = plane.domain_point(points.col(i));
  return result;
}

double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

double distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}

/// Whether no two sides of a polygon meet but neighbours in their common corner.
bool is_simple(const Eigen::Matrix2Xd& polygon) {
  const Eigen::Index n = polygon.cols();
  const auto corner = [&](Eigen::Index i) -> Eigen::Vector2d { return polygon.col(i % n); };
  const double least = 1e-6 * (polygon.rowwise().maxCoeff() - polygon.rowwise().minCoeff()).norm();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d along = corner(i + 1) - corner(i), next = corner(i + 2) - corner(i + 1);
    if (!(along.norm() > 0) || along.normalized().dot(next.normalized()) < -1 + 1e-4) return false;
    for (Eigen::Index j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      if (area(corner(i), corner(i + 1), corner(j)) * area(corner(i), corner(i + 1), corner(j + 1)) < 0 &&
          area(corner(j), corner(j + 1), corner(i)) * area(corner(j), corner(j + 1), corner(i + 1)) < 0)
        return false;
      if (distance(corner(j), corner(i), corner(i + 1)) < least ||
          distance(corner(i), corner(j), corner(j + 1)) < least)
        return false;
    }
  }
  return true;
}

std::array<KnotVector, 2> knots_over(const Eigen::Matrix2Xd& polygon, int spans) {
  const Eigen::Vector2d low = polygon.rowwise().minCoeff(), high = polygon.rowwise().maxCoeff();
  const KnotVector unit = KnotVector::uniform(degree, spans);
  return {rescaled(unit, low.x(), high.x()), rescaled(unit, low.y(), high.y())};
}

double deviation(const LoopSurface& surface, const Eigen::Matrix3Xd& points) {
  double worst = 0;
  for (const auto& point : points.colwise())
    worst = larger(worst, (surface.surface.point(surface.domain_point(point)) - point).norm());
  return worst;
}

}  // namespace

std::optional<LoopSurface> loop_surface(const std::vector<LoopSegment>& loop, double tolerance) {
  if (loop.size() < 3) return std::nullopt;
  std::optional<LoopSurface> result = plane_of(points_of(loop, 16, 0));
  if (!result || !is_simple(seen_from_above(*result, points_of(loop, 16, 0)))) return std::nullopt;
  for (const int spans : {6, 12, 24}) {
    const Eigen::Matrix3Xd points = points_of(loop, 6 * spans, 0);
    const Eigen::Matrix2Xd uv = seen_from_above(*result, points);
    result->surface = smooth_surface({uv, points}, knots_over(uv, spans));
    result->deviation = deviation(*result, points_of(loop, 12 * spans + 1, 0.5));
    if (result->deviation <= tolerance) break;
  }
  return result;
}

}  // namespace isopatch::geometry
