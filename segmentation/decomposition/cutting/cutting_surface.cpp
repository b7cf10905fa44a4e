#include "segmentation/decomposition/cutting/cutting_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "segmentation/decomposition/cutting/spline_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;
using geometry::KnotVector;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::PlaneSurface;

Eigen::Matrix3Xd points_along(const CellGeometry& geometry, const std::vector<EdgeUse>& walk) {
  std::vector<Eigen::Vector3d> points;
  for (const EdgeUse& use : walk) {
    const int pieces = geometry.is_straight(use.edge) ? 1 : 16;
    for (int i = 0; i < pieces; ++i) {
      const double t = double(i) / pieces;
      points.push_back(geometry.point(use.edge, use.reversed ? 1 - t : t));
    }
  }
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = points[i];
  return result;
}

std::optional<PlaneSurface> plane_through(const Eigen::Matrix3Xd& points, double tolerance) {
  const Eigen::Vector3d centre = points.rowwise().mean();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Index n = points.cols();
  for (Eigen::Index i = 0; i < n; ++i)
    normal += (points.col(i) - centre).cross(points.col((i + 1) % n) - centre);
  if (!(normal.norm() > 0)) return std::nullopt;
  normal.normalize();
  if (((points.colwise() - centre).transpose() * normal).cwiseAbs().maxCoeff() > tolerance) return std::nullopt;
  PlaneSurface plane;
  plane.origin = centre;
  Eigen::Vector3d along = points.col(1) - points.col(0);
  along -= along.dot(normal) * normal;
  plane.x = along.normalized();
  plane.y = normal.cross(plane.x);
  return plane;
}

/// The side of the unit square that an edge of the walk lies on, in its own parameter from `low` to `high` of its curve.
NurbsCurve trace_of(const geometry::CellEdge& edge, bool reversed, std::size_t side) {
  const std::array<Eigen::Vector3d, 4> corners = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                                  Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 1, 0)};
  Eigen::Vector3d from = corners[side], to = corners[(side + 1) % 4];
  if (reversed) std::swap(from, to);
  const Eigen::Vector3d pace = (to - from) / (edge.high - edge.low);
  Eigen::Matrix3Xd ends(3, 2);
  ends << from - edge.low * pace, from + (1 - edge.low) * pace;
  return NurbsCurve({KnotVector()}, ends);
}

CuttingSurface coons_patch(const CellGeometry& geometry, const std::vector<EdgeUse>& walk, double tolerance) {
  // Sides in the directions of u and v: below, right, above, left.
  const auto side = [&](std::size_t k) -> CurvePoints {
    const EdgeUse use = walk[k];
    const bool against = use.reversed != (k >= 2);
    return [&geometry, use, against](double t) { return geometry.point(use.edge, against ? 1 - t : t); };
  };
  const std::array<CurvePoints, 4> sides = {side(0), side(1), side(2), side(3)};
  const KnotVector u = following_knots({sides[0], sides[2]}, tolerance),
                   v = following_knots({sides[1], sides[3]}, tolerance);
  const NurbsCurve below = interpolated(sides[0], u), above = interpolated(sides[2], u),
                   right = interpolated(sides[1], v), left = interpolated(sides[3], v);
  const std::vector<double> at_u = u.greville(), at_v = v.greville();
  Eigen::Matrix3Xd net(3, u.size() * v.size());
  for (int j = 0; j < v.size(); ++j)
    for (int i = 0; i < u.size(); ++i) {
      const double s = at_u[static_cast<std::size_t>(i)], t = at_v[static_cast<std::size_t>(j)];
      const auto c = [](const NurbsCurve& curve, int k) -> Eigen::Vector3d { return curve.control_points().col(k); };
      const Eigen::Vector3d corners = (1 - s) * (1 - t) * c(below, 0) + s * (1 - t) * c(below, u.size() - 1) +
                                      (1 - s) * t * c(above, 0) + s * t * c(above, u.size() - 1);
      net.col(i + u.size() * j) = (1 - t) * c(below, i) + t * c(above, i) + (1 - s) * c(left, j) +
                                  s * c(right, j) - corners;
    }
  CuttingSurface result;
  result.surface = NurbsSurface({u, v}, net);
  for (std::size_t k = 0; k < 4; ++k)
    result.traces.push_back(trace_of(geometry.complex().edge(walk[k].edge), walk[k].reversed, k));
  return result;
}

}  // namespace

std::optional<CuttingSurface> cutting_surface(const CellGeometry& geometry, const std::vector<EdgeUse>& walk,
                                              double tolerance) {
  if (auto plane = plane_through(points_along(geometry, walk), tolerance)) return CuttingSurface{*plane, {}};
  if (walk.size() != 4) return std::nullopt;
  return coons_patch(geometry, walk, tolerance);
}

}  // namespace isopatch::segmentation
