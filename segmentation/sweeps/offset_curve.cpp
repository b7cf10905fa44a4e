#include "segmentation/sweeps/internal/offset_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "segmentation/sweeps/internal/straight_wall.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::NurbsCurve;
using geometry::Parameter;

/// Of the circle through the ends and the middle of a curve.
Eigen::Vector3d centre_of_arc(const NurbsCurve& curve, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d a = curve.point(curve.low()), b = curve.point(curve.high());
  const Eigen::Vector3d middle = curve.point(Parameter<1>((curve.low()[0] + curve.high()[0]) / 2));
  const Eigen::Vector3d u = b - a, w = middle - a;
  const Eigen::Vector3d across_u = normal.cross(u), across_w = normal.cross(w);
  // Where the bisectors of both chords meet: (c - a) . u = u.u / 2, (c - a) . w = w.w / 2.
  const double area = u.cross(w).dot(normal);
  return a + (u.squaredNorm() / 2 * across_w - w.squaredNorm() / 2 * across_u) / -area;
}

}  // namespace

std::optional<NurbsCurve> offset_curve(const NurbsCurve& curve, const Eigen::Vector3d& normal, double by) {
  if (is_segment(curve)) {
    const Eigen::Vector3d along = curve.control_points().col(1) - curve.control_points().col(0);
    const Eigen::Vector3d left = normal.cross(along).normalized();
    return NurbsCurve(curve.knots(), curve.control_points().colwise() + by * left, curve.weights());
  }
  const Eigen::Vector3d centre = centre_of_arc(curve, normal);
  const double radius = (curve.point(curve.low()) - centre).norm();
  for (const double share : {0.2, 0.4, 0.7, 0.9, 1.0}) {
    const Parameter<1> at((1 - share) * curve.low()[0] + share * curve.high()[0]);
    if (!(std::abs((curve.point(at) - centre).norm() - radius) <= 1e-7 * radius)) return std::nullopt;
  }
  const Eigen::Vector3d left = normal.cross(curve.jacobian(curve.low()).col(0)).normalized();
  const double grown = radius + (left.dot(curve.point(curve.low()) - centre) > 0 ? by : -by);
  if (!(grown > 1e-3 * radius)) return std::nullopt;
  return NurbsCurve(curve.knots(),
                    (grown / radius * (curve.control_points().colwise() - centre)).colwise() + centre,
                    curve.weights());
}

}  // namespace isopatch::segmentation
