#include "segmentation/reconstruction/internal/carrier_domain.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "segmentation/reconstruction/internal/carrier_distance.hpp"

namespace isopatch::segmentation {

using geometry::Carrier;
using geometry::SurfaceKind;

CarrierDomain::CarrierDomain(const Carrier& carrier)
    : carrier_(carrier), x_(any_normal(carrier.axis)), y_(carrier.axis.cross(x_)) {}

Eigen::Vector2d CarrierDomain::parameters(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d way = point - carrier_.origin;
  const double a = x_.dot(way), b = y_.dot(way), height = carrier_.axis.dot(way), distance = std::hypot(a, b);
  const double turn = std::atan2(b, a);
  if (carrier_.kind == SurfaceKind::sphere) return {turn, std::atan2(height, distance)};
  if (carrier_.kind == SurfaceKind::torus) return {turn, std::atan2(height, distance - carrier_.radius)};
  return {turn, height};
}

Eigen::Vector3d CarrierDomain::point(const Eigen::Vector2d& p) const {
  const Eigen::Vector3d outward = std::cos(p.x()) * x_ + std::sin(p.x()) * y_;
  const Eigen::Vector3d &axis = carrier_.axis, &origin = carrier_.origin;
  switch (carrier_.kind) {
    case SurfaceKind::sphere:
      return origin + carrier_.radius * (std::cos(p.y()) * outward + std::sin(p.y()) * axis);
    case SurfaceKind::torus:
      return origin + (carrier_.radius + carrier_.second_radius * std::cos(p.y())) * outward +
             carrier_.second_radius * std::sin(p.y()) * axis;
    case SurfaceKind::cone:
      return origin + (carrier_.radius + p.y() * std::tan(carrier_.half_angle.radians())) * outward +
             p.y() * axis;
    default:
      return origin + carrier_.radius * outward + p.y() * axis;
  }
}

Carrier CarrierDomain::meridian(double turn) const {
  return {SurfaceKind::plane, carrier_.origin, std::cos(turn) * y_ - std::sin(turn) * x_, 0, 0, {}};
}

Carrier CarrierDomain::parallel(double turn) const {
  const double sine = std::sin(turn), cosine = std::cos(turn);
  // Normals of the tube are the rulings of a cone through the middle circle.
  if (std::abs(sine) < 1e-6) return {SurfaceKind::plane, carrier_.origin, carrier_.axis, 0, 0, {}};
  if (std::abs(cosine) < 1e-6)
    return {SurfaceKind::cylinder, carrier_.origin, carrier_.axis, carrier_.radius, 0, {}};
  return {SurfaceKind::cone,
          carrier_.origin,
          carrier_.axis,
          carrier_.radius,
          0,
          Angle::radians(std::atan(cosine / sine))};
}

}  // namespace isopatch::segmentation
