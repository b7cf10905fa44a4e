#include "segmentation/decomposition/cutting/cutting_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/loop_surface.hpp"
#include "geometry/splines/arc.hpp"
#include "segmentation/decomposition/cutting/spline_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;
using geometry::KnotVector;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::PlaneSurface;

/// A step of a walk as one curve over [0, 1]: its edges share the interval as they do their curve, if they
/// are pieces of one, or by length.
class StepCurve {
 public:
  StepCurve(const CellShapes& shapes, const std::vector<EdgeUse>& step) : shapes_(&shapes), step_(step) {
    const auto edge = [&](const EdgeUse& use) { return shapes.complex().edge(use.edge); };
    const bool one_curve = std::all_of(step.begin(), step.end(), [&](const EdgeUse& use) {
      return edge(use).curve == edge(step.front()).curve;
    });
    ends_.push_back(0);
    for (const EdgeUse& use : step)
      ends_.push_back(ends_.back() + (one_curve
                                          ? edge(use).high - edge(use).low
                                          : (shapes.point(use.edge, 1) - shapes.point(use.edge, 0)).norm()));
    for (double& end : ends_) end /= ends_.back();
    ends_.back() = 1;
  }

  Eigen::Vector3d point(double t) const {
    std::size_t k = 0;
    while (k + 1 < step_.size() && t > ends_[k + 1]) ++k;
    const double share = (t - ends_[k]) / (ends_[k + 1] - ends_[k]);
    return shapes_->point(step_[k].edge, step_[k].reversed ? 1 - share : share);
  }
  /// Where edge k of the step starts and ends.
  std::array<double, 2> stretch(std::size_t k) const { return {ends_[k], ends_[k + 1]}; }

 private:
  const CellShapes* shapes_;
  std::vector<EdgeUse> step_;
  std::vector<double> ends_;
};

/// The stretch of a side of the unit square that an edge of the walk lies on, in the parameter of its curve.
NurbsCurve trace_of(const geometry::CellEdge& edge, bool reversed, std::size_t side,
                    std::array<double, 2> stretch) {
  const std::array<Eigen::Vector3d, 4> corners = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                                  Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 1, 0)};
  const Eigen::Vector3d start = corners[side], whole = corners[(side + 1) % 4] - start;
  Eigen::Vector3d from = start + stretch[0] * whole, to = start + stretch[1] * whole;
  if (reversed) std::swap(from, to);
  const Eigen::Vector3d pace = (to - from) / (edge.high - edge.low);
  return geometry::segment(from - edge.low * pace, from + (1 - edge.low) * pace);
}

std::optional<CuttingSurface> coons_patch(const CellShapes& shapes, const StepWalk& steps, double tolerance) {
  std::vector<StepCurve> curves;
  for (const auto& step : steps) curves.emplace_back(shapes, step);
  // Sides in the directions of u and v: below, right, above, left.
  const auto side = [&](std::size_t k) -> CurvePoints {
    return [&curve = curves[k], against = k >= 2](double t) { return curve.point(against ? 1 - t : t); };
  };
  const std::array<CurvePoints, 4> sides = {side(0), side(1), side(2), side(3)};
  const KnotVector u = following_knots({sides[0], sides[2]}, tolerance),
                   v = following_knots({sides[1], sides[3]}, tolerance);
  const NurbsCurve below = interpolated(sides[0], u), above = interpolated(sides[2], u),
                   right = interpolated(sides[1], v), left = interpolated(sides[3], v);
  if (!(std::max({deviation(sides[0], below), deviation(sides[1], right), deviation(sides[2], above),
                  deviation(sides[3], left)}) <= 100 * tolerance))
    return std::nullopt;
  const std::vector<double> at_u = u.greville(), at_v = v.greville();
  Eigen::Matrix3Xd net(3, u.size() * v.size());
  const auto c = [](const NurbsCurve& curve, int k) -> Eigen::Vector3d {
    return curve.control_points().col(k);
  };
  for (int j = 0; j < v.size(); ++j)
    for (int i = 0; i < u.size(); ++i) {
      const double s = at_u[static_cast<std::size_t>(i)], t = at_v[static_cast<std::size_t>(j)];
      const Eigen::Vector3d corners = (1 - s) * (1 - t) * c(below, 0) + s * (1 - t) * c(below, u.size() - 1) +
                                      (1 - s) * t * c(above, 0) + s * t * c(above, u.size() - 1);
      net.col(i + u.size() * j) =
          (1 - t) * c(below, i) + t * c(above, i) + (1 - s) * c(left, j) + s * c(right, j) - corners;
    }
  CuttingSurface result;
  result.surface = NurbsSurface({u, v}, net);
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < steps[k].size(); ++i)
      result.traces.push_back(
          trace_of(shapes.complex().edge(steps[k][i].edge), steps[k][i].reversed, k, curves[k].stretch(i)));
  return result;
}

/// The trace of a curve by what it is seen as from above a surface, in the parameter of the curve.
NurbsCurve seen_from_above(const CellShapes& shapes, EdgeId id, const geometry::LoopSurface& surface,
                           double tolerance) {
  const geometry::CellEdge& edge = shapes.complex().edge(id);
  const CurvePoints trace = [&](double s) -> Eigen::Vector3d {
    const Eigen::Vector2d uv =
        surface.domain_point(shapes.point(id, (s - edge.low) / (edge.high - edge.low)));
    return {uv.x(), uv.y(), 0};
  };
  return interpolated(trace, following_knots({trace}, tolerance));
}

std::optional<CuttingSurface> smooth_patch(const CellShapes& shapes, const StepWalk& steps,
                                           double tolerance) {
  std::vector<geometry::LoopSegment> loop;
  const std::vector<EdgeUse> walk = joined(steps);
  for (const EdgeUse& use : walk)
    loop.emplace_back([&shapes, use](double t) { return shapes.point(use.edge, use.reversed ? 1 - t : t); });
  const auto found = geometry::loop_surface(loop, 100 * tolerance);
  if (!found || !(found->deviation <= 1e4 * tolerance)) return std::nullopt;
  CuttingSurface result;
  result.surface = found->surface;
  for (const EdgeUse& use : walk)
    result.traces.push_back(seen_from_above(shapes, use.edge, *found, tolerance));
  return result;
}

}  // namespace

Eigen::Matrix3Xd points_along(const CellShapes& shapes, const std::vector<EdgeUse>& walk) {
  std::vector<Eigen::Vector3d> points;
  for (const EdgeUse& use : walk) {
    const int pieces = shapes.is_straight(use.edge) ? 1 : 16;
    for (int i = 0; i < pieces; ++i) {
      const double t = double(i) / pieces;
      points.push_back(shapes.point(use.edge, use.reversed ? 1 - t : t));
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
  if (((points.colwise() - centre).transpose() * normal).cwiseAbs().maxCoeff() > tolerance)
    return std::nullopt;
  PlaneSurface plane;
  plane.origin = centre;
  Eigen::Vector3d along = points.col(1) - points.col(0);
  along -= along.dot(normal) * normal;
  plane.x = along.normalized();
  plane.y = normal.cross(plane.x);
  return plane;
}

std::vector<EdgeUse> joined(const StepWalk& steps) {
  std::vector<EdgeUse> result;
  for (const auto& step : steps) result.insert(result.end(), step.begin(), step.end());
  return result;
}

std::optional<CuttingSurface> cutting_surface(const CellShapes& shapes, const StepWalk& steps,
                                              double tolerance, bool any) {
  if (auto plane = plane_through(points_along(shapes, joined(steps)), tolerance))
    return CuttingSurface{*plane, {}};
  if (steps.size() == 4)
    if (auto patch = coons_patch(shapes, steps, tolerance)) return patch;
  return any ? smooth_patch(shapes, steps, tolerance) : std::nullopt;
}

}  // namespace isopatch::segmentation
