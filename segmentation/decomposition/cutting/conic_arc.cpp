#include "segmentation/decomposition/cutting/conic_arc.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::PlaneSurface;
using geometry::SurfaceKind;

/// Sines of angles between directions that are one.
constexpr double same_direction = 1e-9;
constexpr double widest_piece = 2 * std::numbers::pi / 3 + 1e-9;

/// A circle, and the centre from which its points are projected into the plane of a section, in homogeneous
/// coordinates: at infinity for a cylinder, the apex of a cone; nothing where the circle is the section.
struct ProjectedCircle {
  Eigen::Vector3d center, x, y;  ///< half axes of the circle, at right angles
  std::optional<Eigen::Vector4d> eye = {};
};

/// The circle about an axis through a point.
std::optional<ProjectedCircle> circle_about(const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                                            const Eigen::Vector3d& point) {
  const Eigen::Vector3d foot = center + axis * axis.dot(point - center), radius = point - foot;
  if (!(radius.norm() > 0)) return std::nullopt;
  return ProjectedCircle{foot, radius, axis.cross(radius)};
}

std::optional<ProjectedCircle> seen_from(const std::optional<ProjectedCircle>& circle,
                                         const Eigen::Vector4d& eye) {
  if (!circle) return std::nullopt;
  ProjectedCircle result = *circle;
  result.eye = eye;
  return result;
}

/// The circle about which a section goes, with `from` at angle 0.
std::optional<ProjectedCircle> circle_of(const Carrier& carrier, const PlaneSurface& plane,
                                         const Eigen::Vector3d& from) {
  const Eigen::Vector3d normal = plane.normal();
  switch (carrier.kind) {
    case SurfaceKind::cylinder:
      if (std::abs(normal.dot(carrier.axis)) < same_direction) return std::nullopt;
      return seen_from(circle_about(carrier.origin, carrier.axis, from),
                       {carrier.axis.x(), carrier.axis.y(), carrier.axis.z(), 0});
    case SurfaceKind::cone: {
      const Eigen::Vector3d apex =
          carrier.origin - carrier.axis * (carrier.radius / std::tan(carrier.half_angle.radians()));
      if (std::abs(normal.dot(apex - plane.origin)) < same_direction * (from - apex).norm())
        return std::nullopt;
      return seen_from(circle_about(apex, carrier.axis, from), {apex.x(), apex.y(), apex.z(), 1});
    }
    case SurfaceKind::sphere:
      return circle_about(carrier.origin, normal, from);
    case SurfaceKind::torus: {
      if (normal.cross(carrier.axis).norm() < same_direction)
        return circle_about(carrier.origin, carrier.axis, from);
      if (std::abs(normal.dot(carrier.axis)) > same_direction ||
          std::abs(normal.dot(carrier.origin - plane.origin)) > same_direction * carrier.radius)
        return std::nullopt;
      const Eigen::Vector3d out =
          from - carrier.origin - carrier.axis * carrier.axis.dot(from - carrier.origin);
      return circle_about(carrier.origin + carrier.radius * out.normalized(), normal, from);
    }
    default:
      return std::nullopt;
  }
}

double angle_of(const ProjectedCircle& circle, const Eigen::Vector3d& point) {
  return std::atan2(circle.y.dot(point - circle.center), circle.x.dot(point - circle.center));
}

/// The way from one angle to another, less than half a turn.
double short_way(double from, double to) {
  return std::remainder(to - from, 2 * std::numbers::pi);
}

/// The arc of a circle in homogeneous coordinates: points times weights, weights.
Eigen::Matrix4Xd arc(const ProjectedCircle& circle, double sweep, int pieces) {
  const double step = sweep / pieces / 2, weight = std::cos(step);
  Eigen::Matrix4Xd result(4, 2 * pieces + 1);
  for (int i = 0; i <= 2 * pieces; ++i) {
    const double share = i % 2 == 1 ? weight : 1;
    const Eigen::Vector3d out = std::cos(i * step) * circle.x + std::sin(i * step) * circle.y;
    result.col(i) << share * circle.center + out, share;
  }
  return result;
}

/// Projects points, all to one side of the centre of projection, into a plane.
bool project(Eigen::Matrix4Xd& points, const Eigen::Vector4d& eye, const PlaneSurface& plane) {
  const Eigen::Vector3d normal = plane.normal();
  Eigen::RowVector4d form;
  form << normal.transpose(), -normal.dot(plane.origin);
  points = (form * eye).value() * points - eye * (form * points);
  if (points(3, 0) < 0) points = -points;
  return points.row(3).minCoeff() > 0;
}

/// Makes end weights 1, which takes another parameter where they differ; only one piece can have another.
bool normalise(Eigen::Matrix4Xd& points) {
  points /= points(3, 0);
  const Eigen::Index last = points.cols() - 1;
  if (std::abs(points(3, last) - 1) > 1e-13) {
    if (points.cols() != 3) return false;
    const double factor = 1 / std::sqrt(points(3, last));
    points.col(1) *= factor;
    points.col(2) *= factor * factor;
  }
  points.col(last) /= points(3, last);
  return true;
}

}  // namespace

std::optional<geometry::NurbsCurve> conic_arc(const Carrier& carrier, const PlaneSurface& plane,
                                              const Eigen::Vector3d& from, const Eigen::Vector3d& by,
                                              const Eigen::Vector3d& to) {
  const auto circle = circle_of(carrier, plane, from);
  if (!circle) return std::nullopt;
  const double half_way = angle_of(*circle, by);
  const double sweep = short_way(0, half_way) + short_way(half_way, angle_of(*circle, to));
  if (!(std::abs(sweep) > 0)) return std::nullopt;
  const int pieces = static_cast<int>(std::ceil(std::abs(sweep) / widest_piece));
  Eigen::Matrix4Xd points = arc(*circle, sweep, pieces);
  if (circle->eye && !project(points, *circle->eye, plane)) return std::nullopt;
  if (!normalise(points)) return std::nullopt;
  const Eigen::VectorXd weights = points.row(3);
  return geometry::NurbsCurve({geometry::KnotVector::uniform(2, pieces, 2)},
                              points.topRows<3>() * weights.cwiseInverse().asDiagonal(), weights);
}

}  // namespace isopatch::segmentation
