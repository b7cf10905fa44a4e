#include "segmentation/reconstruction/internal/carrier_distance.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::SurfaceKind;

/// A point as seen from a carrier: its height along the axis, its distance from it, and the way there.
struct AxisView {
  double height, distance;
  Eigen::Vector3d outward;
};

AxisView seen_from_axis(const Carrier& carrier, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = point - carrier.origin;
  const double height = carrier.axis.dot(way);
  const Eigen::Vector3d across = way - height * carrier.axis;
  const double distance = across.norm();
  return {height, distance, distance > 0 ? Eigen::Vector3d(across / distance) : any_normal(carrier.axis)};
}

CarrierDistance cone_distance(const Carrier& carrier, double cosine, double sine,
                              const Eigen::Vector3d& point) {
  const AxisView view = seen_from_axis(carrier, point);
  const double off = view.distance - carrier.radius;
  CarrierDistance result;
  result.value = off * cosine - view.height * sine;
  result.gradient = cosine * view.outward - sine * carrier.axis;
  result.by_radius = -cosine;
  result.by_second = -off * sine - view.height * cosine;
  return result;
}

CarrierDistance torus_distance(const Carrier& carrier, const Eigen::Vector3d& point) {
  const AxisView view = seen_from_axis(carrier, point);
  const Eigen::Vector2d to(view.distance - carrier.radius, view.height);
  const double length = to.norm();
  const Eigen::Vector2d along = length > 0 ? Eigen::Vector2d(to / length) : Eigen::Vector2d(1, 0);
  CarrierDistance result;
  result.value = length - carrier.second_radius;
  result.gradient = along.x() * view.outward + along.y() * carrier.axis;
  result.by_radius = -along.x();
  result.by_second = -1;
  return result;
}

}  // namespace

CarrierDistances::CarrierDistances(const Carrier& carrier)
    : carrier_(carrier),
      cosine_(std::cos(carrier.half_angle.radians())),
      sine_(std::sin(carrier.half_angle.radians())) {}

CarrierDistance CarrierDistances::at(const Eigen::Vector3d& point) const {
  switch (carrier_.kind) {
    case SurfaceKind::cylinder: {
      const AxisView view = seen_from_axis(carrier_, point);
      return {view.distance - carrier_.radius, view.outward, -1, 0};
    }
    case SurfaceKind::cone:
      return cone_distance(carrier_, cosine_, sine_, point);
    case SurfaceKind::sphere: {
      const Eigen::Vector3d way = point - carrier_.origin;
      const double length = way.norm();
      return {length - carrier_.radius, length > 0 ? Eigen::Vector3d(way / length) : carrier_.axis, -1, 0};
    }
    case SurfaceKind::torus:
      return torus_distance(carrier_, point);
    default:
      return {carrier_.axis.dot(point - carrier_.origin), carrier_.axis, 0, 0};
  }
}

CarrierDistance carrier_distance(const Carrier& carrier, const Eigen::Vector3d& point) {
  return CarrierDistances(carrier).at(point);
}

int freedoms(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane:
      return 3;
    case SurfaceKind::sphere:
      return 4;
    case SurfaceKind::cylinder:
      return 5;
    case SurfaceKind::cone:
      return 6;
    default:
      return 7;
  }
}

Eigen::Vector3d any_normal(const Eigen::Vector3d& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Eigen::Vector3d::Unit(least)).normalized();
}

}  // namespace isopatch::segmentation
