#include "geometry/splines/arc.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

void check_sweep(Angle sweep) {
  const double size = std::abs(sweep.radians());
  if (!(size > 0 && size < std::numbers::pi))
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("an arc of {:g} degrees: one piece takes more than 0 and less than 180; join several",
                    sweep.degrees()));
}

NurbsCurve quadratic(const Eigen::Vector3d& first, const Eigen::Vector3d& middle, const Eigen::Vector3d& last,
                     double weight) {
  Eigen::Matrix3Xd points(3, 3);
  points << first, middle, last;
  return NurbsCurve({KnotVector::bezier(2)}, points, Eigen::Vector3d(1, weight, 1));
}

}  // namespace

NurbsCurve arc(const Eigen::Vector3d& center, double radius, Angle from, Angle to) {
  if (!(radius > 0))
    throw Error(ErrorCode::invalid_argument, fmt::format("an arc of radius {}: it must be positive", radius));
  check_sweep(to - from);
  const auto at = [&](double angle, double distance) {
    return Eigen::Vector3d(center + distance * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  };
  const double weight = std::cos(0.5 * (to - from).radians());
  return quadratic(at(from.radians(), radius), at(0.5 * (from + to).radians(), radius / weight),
                   at(to.radians(), radius), weight);
}

NurbsCurve arc_about(const Eigen::Vector3d& center, const Eigen::Vector3d& axis, const Eigen::Vector3d& start,
                     Angle sweep) {
  check_sweep(sweep);
  if (!(axis.norm() > 0)) throw Error(ErrorCode::invalid_argument, "an arc about an axis of no length");
  const Eigen::Vector3d direction = axis.normalized();
  const Eigen::Vector3d foot = center + direction * direction.dot(start - center);
  const Eigen::Vector3d x = start - foot;
  if (!(x.norm() > 0)) throw Error(ErrorCode::invalid_argument, "an arc that starts on its own axis");
  const Eigen::Vector3d y = direction.cross(x);
  const double angle = sweep.radians();
  const double weight = std::cos(0.5 * angle);
  return quadratic(start, foot + x + std::tan(0.5 * angle) * y,
                   foot + std::cos(angle) * x + std::sin(angle) * y, weight);
}

NurbsCurve segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Eigen::Matrix3Xd points(3, 2);
  points << from, to;
  return NurbsCurve({KnotVector::bezier(1)}, points);
}

int arc_piece_count(Angle sweep, Angle largest_piece) {
  if (!(sweep > Angle() && largest_piece > Angle()))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("cannot divide {:g} degrees into pieces of {:g} degrees", sweep.degrees(),
                            largest_piece.degrees()));
  // 360 degrees in pieces of 90 are four, whatever the rounding of pi.
  constexpr double round_off = 1e-12;
  return static_cast<int>(std::ceil(sweep.radians() / largest_piece.radians() * (1 - round_off)));
}

}  // namespace isopatch::geometry
