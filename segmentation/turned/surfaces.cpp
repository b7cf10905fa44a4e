#include "segmentation/turned/internal/surfaces.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "geometry/base/angle.hpp"
#include "geometry/splines/arc.hpp"

namespace isopatch::segmentation {

using geometry::KnotVector;
using geometry::NurbsCurve;
using geometry::NurbsSurface;

NurbsSurface turned_surface(const NurbsCurve& curve, const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& axis, double sweep) {
  const Eigen::Matrix3d half = Eigen::AngleAxisd(sweep / 2, axis).toRotationMatrix(),
                        whole = Eigen::AngleAxisd(sweep, axis).toRotationMatrix();
  const double weight = std::cos(sweep / 2);
  Eigen::Matrix3Xd points(3, 3 * curve.size());
  Eigen::VectorXd weights(3 * curve.size());
  for (Eigen::Index i = 0; i < curve.size(); ++i) {
    const Eigen::Vector3d way = curve.control_points().col(i) - origin;
    const Eigen::Vector3d foot = axis * axis.dot(way), out = way - foot;
    points.col(3 * i) = origin + way;
    points.col(3 * i + 1) = origin + foot + half * out / weight;
    points.col(3 * i + 2) = origin + foot + whole * out;
    weights.segment<3>(3 * i) = curve.weights()[i] * Eigen::Vector3d(1, weight, 1);
  }
  return NurbsSurface({KnotVector(2, {0, 0, 0, 1, 1, 1}), curve.knots(0)}, points, weights);
}

Eigen::Vector3d Spheroid::stretched(const Eigen::Vector3d& point) const {
  return point + (stretch - 1) * (point - centre).dot(along) * along;
}

Eigen::Vector3d Spheroid::unstretched(const Eigen::Vector3d& point) const {
  return point + (1 / stretch - 1) * (point - centre).dot(along) * along;
}

NurbsCurve Spheroid::arc(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const Eigen::Vector3d start = unstretched(from), u = start - centre, v = unstretched(to) - centre;
  const Eigen::Vector3d normal = u.cross(v);
  const NurbsCurve round =
      geometry::arc_about(centre, normal, start, Angle::radians(std::atan2(normal.norm(), u.dot(v))));
  Eigen::Matrix3Xd points = round.control_points();
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = stretched(points.col(i));
  return NurbsCurve(round.knots(), points, round.weights());
}

SpherePatch::SpherePatch(const Spheroid& spheroid, const Eigen::Vector3d& middle, bool inwards)
    : spheroid_(spheroid), z_(middle) {
  x_ = middle.unitOrthogonal();
  y_ = middle.cross(x_) * (inwards ? -1 : 1);
}

NurbsSurface SpherePatch::surface(double reach) const {
  // Blossoms of 1, t and t^2 on the knots -reach, 0, reach.
  const Eigen::Vector4d one = Eigen::Vector4d::Ones(), t = reach * Eigen::Vector4d(-1, -0.5, 0.5, 1),
                        square = reach * reach * Eigen::Vector4d(1, 0, 0, 1);
  Eigen::Matrix4Xd points(4, 16);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const double squares = square[i] + square[j], weight = one[i] + squares;
      const Eigen::Vector3d out = 2 * t[i] * x_ + 2 * t[j] * y_ + (1 - squares) * z_;
      points.col(i + 4 * j) << weight *
                                   spheroid_.stretched(spheroid_.centre + spheroid_.radius / weight * out),
          weight;
    }
  const KnotVector knots(2, {-reach, -reach, -reach, 0, reach, reach, reach});
  return NurbsSurface::from_homogeneous({knots, knots}, points);
}

NurbsCurve SpherePatch::trace(const NurbsCurve& curve) const {
  Eigen::Matrix3Xd points(3, curve.size());
  Eigen::VectorXd weights(curve.size());
  for (Eigen::Index i = 0; i < curve.size(); ++i) {
    const Eigen::Vector3d way = spheroid_.unstretched(curve.control_points().col(i)) - spheroid_.centre;
    const double below = spheroid_.radius + way.dot(z_);
    points.col(i) << way.dot(x_) / below, way.dot(y_) / below, 0;
    weights[i] = curve.weights()[i] * below;
  }
  return NurbsCurve(curve.knots(), points, weights);
}

}  // namespace isopatch::segmentation
