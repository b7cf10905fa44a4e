#include "segmentation/branches/internal/plan_curve.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/base/angle.hpp"
#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/sweeps/piece_of_curve.hpp"

namespace isopatch::segmentation {
namespace {

Eigen::Vector3d in_space(const Eigen::Vector2d& point) {
  return {point.x(), point.y(), 0};
}

}  // namespace

bool PlanCurve::is_circle() const {
  return std::abs(sweep) > 2 * std::numbers::pi - 1e-9;
}

Eigen::Vector2d PlanCurve::point(double share) const {
  if (spline) return spline->point(geometry::Parameter<1>(share)).head<2>();
  if (is_straight()) return from + share * (to - from);
  return centre + Eigen::Rotation2Dd(share * sweep) * (from - centre);
}

geometry::NurbsCurve PlanCurve::piece(double low, double high) const {
  if (is_straight()) return geometry::segment(in_space(point(low)), in_space(point(high)));
  if (spline) return piece_of_curve(*spline, low, high);
  const double turn = (high - low) * sweep;
  if (std::abs(turn) > Angle::degrees(170).radians())
    throw Error(ErrorCode::unsupported, "an arc of a branch's outline has to be divided");
  return geometry::arc_about(in_space(centre), Eigen::Vector3d::UnitZ(), in_space(point(low)),
                             Angle::radians(turn));
}

PlanCurve PlanCurve::reversed() const {
  PlanCurve result{to, from, centre, -sweep};
  if (spline) result.spline = geometry::reversed(*spline, 0);
  return result;
}

}  // namespace isopatch::segmentation
