#include <Eigen/Geometry>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/brep/opencascade/internal/carrier_forms.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"

namespace isopatch::geometry {
namespace {

constexpr int form_samples = 17;
constexpr double full_turn = 2 * std::numbers::pi;

/// Points of a surface with its unit normals, about their mean and as large as 1.
struct SurfaceSamples {
  Eigen::Matrix3Xd points, normals;
  Eigen::Vector3d mean;
  double size = 0;
};

SurfaceSamples samples_of(const Geom_Surface& surface, const DomainBox& box) {
  constexpr Eigen::Index count = form_samples * form_samples;
  SurfaceSamples result{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count), {}, 0};
  Eigen::Index kept = 0;
  for (int j = 0; j < form_samples; ++j)
    for (int i = 0; i < form_samples; ++i) {
      // Not at the ends: at poles there is no normal.
      const Eigen::Vector2d share((i + 0.5) / form_samples, (j + 0.5) / form_samples);
      const Eigen::Vector2d uv = box.low + share.cwiseProduct(box.high - box.low);
      gp_Pnt p;
      gp_Vec u, v;
      surface.D1(uv.x(), uv.y(), p, u, v);
      const Eigen::Vector3d normal = to_eigen(u.Crossed(v));
      if (!(normal.norm() > 1e-12 * to_eigen(u).norm() * to_eigen(v).norm())) continue;
      result.points.col(kept) = to_eigen(p);
      result.normals.col(kept++) = normal.normalized();
    }
  result.points.conservativeResize(3, kept);
  result.normals.conservativeResize(3, kept);
  if (kept == 0) return result;
  result.mean = result.points.rowwise().mean();
  result.points.colwise() -= result.mean;
  result.size = result.points.colwise().norm().maxCoeff();
  result.points /= result.size;
  return result;
}

/// The direction in which vectors are shortest.
Eigen::Vector3d flattest(const Eigen::Matrix3Xd& vectors) {
  const Eigen::Matrix3d sums = vectors * vectors.transpose();
  return principal_axes(sums).axes.col(0);
}

Eigen::Vector3d any_across(const Eigen::Vector3d& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Eigen::Vector3d::Unit(least)).normalized();
}

/// A circle through points of a plane, by least squares.
struct PlaneCircle {
  Eigen::Vector2d center;
  double radius = 0;
};
std::optional<PlaneCircle> circle_through(const Eigen::Matrix2Xd& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const Eigen::Vector2d mean = points.rowwise().mean();
  for (const auto& column : points.colwise()) {
    const Eigen::Vector2d p = column - mean;
    const Eigen::Vector3d row(2 * p.x(), 2 * p.y(), 1);
    normal += row * row.transpose();
    right += p.squaredNorm() * row;
  }
  const Eigen::Vector3d found = solve_semidefinite(normal, right);
  const double square = found.z() + found.head<2>().squaredNorm();
  if (!(square > 0) || !found.allFinite()) return std::nullopt;
  return PlaneCircle{mean + found.head<2>(), std::sqrt(square)};
}

/// A surface of revolution: its axis, and the samples' distances from it and places along it.
struct Meridian {
  Eigen::Vector3d origin, axis;
  Eigen::Matrix2Xd points;  ///< (distance, place)
};

Meridian meridian_about(const SurfaceSamples& samples, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& axis) {
  Meridian result{origin, axis, Eigen::Matrix2Xd(2, samples.points.cols())};
  for (Eigen::Index i = 0; i < samples.points.cols(); ++i) {
    const Eigen::Vector3d way = samples.points.col(i) - origin;
    result.points.col(i) = Eigen::Vector2d((way - axis * axis.dot(way)).norm(), axis.dot(way));
  }
  return result;
}

/// Whether a surface agrees with all samples, in their units.
template <class Distance>
bool all_within(const Eigen::Matrix2Xd& points, double tolerance, Distance distance) {
  for (const auto& p : points.colwise())
    if (!(std::abs(distance(Eigen::Vector2d(p))) <= tolerance)) return false;
  return true;
}

/// What was found, in the samples' units about their mean.
struct Found {
  SurfaceKind kind = SurfaceKind::other;
  Eigen::Vector3d origin, axis;
  double radius = 0, second = 0;  ///< second: small radius, or the half angle in rad
};

std::optional<Found> plane_of(const SurfaceSamples& samples, double tolerance) {
  const Eigen::Vector3d normal = flattest(samples.points);
  if (!((normal.transpose() * samples.points).cwiseAbs().maxCoeff() <= tolerance)) return std::nullopt;
  const bool along = normal.dot(samples.normals.col(0)) > 0;
  return Found{SurfaceKind::plane, Eigen::Vector3d::Zero(), along ? normal : Eigen::Vector3d(-normal)};
}

std::optional<Found> sphere_of(const SurfaceSamples& samples, double tolerance) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const auto& p : samples.points.colwise()) {
    const Eigen::Vector4d row(2 * p.x(), 2 * p.y(), 2 * p.z(), 1);
    normal += row * row.transpose();
    right += p.squaredNorm() * row;
  }
  const Eigen::Vector4d found = solve_semidefinite(normal, right);
  const Eigen::Vector3d center = found.head<3>();
  const double square = found.w() + center.squaredNorm();
  if (!found.allFinite() || !(square > 0)) return std::nullopt;
  const double radius = std::sqrt(square);
  for (const auto& p : samples.points.colwise())
    if (!(std::abs((p - center).norm() - radius) <= tolerance)) return std::nullopt;
  return Found{SurfaceKind::sphere, center, Eigen::Vector3d::UnitZ(), radius};
}

std::optional<Found> cylinder_of(const SurfaceSamples& samples, double tolerance) {
  const Eigen::Vector3d axis = flattest(samples.normals);
  const Eigen::Vector3d x = any_across(axis), y = axis.cross(x);
  Eigen::Matrix2Xd flat(2, samples.points.cols());
  flat << x.transpose() * samples.points, y.transpose() * samples.points;
  const auto circle = circle_through(flat);
  if (!circle || !all_within(flat, tolerance, [&](const Eigen::Vector2d& p) {
        return (p - circle->center).norm() - circle->radius;
      }))
    return std::nullopt;
  return Found{SurfaceKind::cylinder, circle->center.x() * x + circle->center.y() * y, axis, circle->radius};
}

std::optional<Found> cone_of(const SurfaceSamples& samples, double tolerance) {
  const Eigen::Vector3d mean = samples.normals.rowwise().mean();
  Eigen::Vector3d axis = flattest(samples.normals.colwise() - mean);
  // All planes that touch a cone meet in its apex.
  const Eigen::Matrix3d sums = samples.normals * samples.normals.transpose();
  const Eigen::Vector3d right =
      samples.normals * (samples.normals.cwiseProduct(samples.points).colwise().sum()).transpose();
  const Eigen::Vector3d apex = solve_semidefinite(sums, right);
  if (!apex.allFinite()) return std::nullopt;
  // The axis points the way in which the cone widens.
  if (axis.dot(-apex) < 0) axis = -axis;
  const Meridian meridian = meridian_about(samples, apex, axis);
  const Eigen::Vector2d way = meridian.points.rowwise().mean();
  const double half = std::atan2(way.x(), way.y()), c = std::cos(half), s = std::sin(half);
  if (!(s > 1e-6 && c > 1e-6)) return std::nullopt;
  if (!all_within(meridian.points, tolerance,
                  [&](const Eigen::Vector2d& p) { return c * p.x() - s * p.y(); }))
    return std::nullopt;
  return Found{SurfaceKind::cone, apex + way.y() * axis, axis, way.y() * s / c, half};
}

std::optional<Found> torus_of(const SurfaceSamples& samples, double tolerance) {
  // Every normal meets the axis: with the axis' direction a and moment m, a.(p x n) + m.n = 0.
  Eigen::Matrix<double, 6, 6> sums = Eigen::Matrix<double, 6, 6>::Zero();
  for (Eigen::Index i = 0; i < samples.points.cols(); ++i) {
    Eigen::Matrix<double, 6, 1> row;
    row << samples.points.col(i).cross(samples.normals.col(i)), samples.normals.col(i);
    sums += row * row.transpose();
  }
  const Eigen::Matrix<double, 6, 1> line = symmetric_eigen(sums).vectors.col(0);
  const double length = line.head<3>().norm();
  if (!(length > 1e-6)) return std::nullopt;
  const Eigen::Vector3d axis = line.head<3>() / length, moment = line.tail<3>() / length;
  Meridian meridian = meridian_about(samples, axis.cross(moment), axis);
  const auto circle = circle_through(meridian.points);
  if (!circle || !(circle->center.x() > circle->radius) ||
      !all_within(meridian.points, tolerance,
                  [&](const Eigen::Vector2d& p) { return (p - circle->center).norm() - circle->radius; }))
    return std::nullopt;
  return Found{SurfaceKind::torus, meridian.origin + circle->center.y() * axis, axis, circle->center.x(),
               circle->radius};
}

/// The direction across the planes of a sphere's circles of latitude, as its own parameters have them; any
/// that is far from its points otherwise.
Eigen::Vector3d sphere_axis(const Geom_Surface& surface, const DomainBox& box,
                            const Eigen::Vector3d& center) {
  const auto across = [&](int along, double place) {
    Eigen::Matrix3Xd points(3, form_samples);
    for (int i = 0; i < form_samples; ++i) {
      Eigen::Vector2d share;
      share[along] = (i + 0.5) / form_samples;
      share[1 - along] = place;
      const Eigen::Vector2d uv = box.low + share.cwiseProduct(box.high - box.low);
      points.col(i) = to_eigen(surface.Value(uv.x(), uv.y()));
    }
    const Eigen::Vector3d mean = points.rowwise().mean();
    return flattest(points.colwise() - mean);
  };
  for (const int along : {0, 1}) {
    const Eigen::Vector3d first = across(along, 0.25), second = across(along, 0.7);
    if (first.cross(second).norm() < 1e-6) return first;
  }
  const Eigen::Vector2d middle = (box.low + box.high) / 2;
  return any_across((to_eigen(surface.Value(middle.x(), middle.y())) - center).normalized());
}

Handle(Geom_Surface) made(const Found& found, const gp_Ax3& frame) {
  switch (found.kind) {
    case SurfaceKind::plane:
      return new Geom_Plane(frame);
    case SurfaceKind::cylinder:
      return new Geom_CylindricalSurface(frame, found.radius);
    case SurfaceKind::cone:
      return new Geom_ConicalSurface(frame, found.second, found.radius);
    case SurfaceKind::sphere:
      return new Geom_SphericalSurface(frame, found.radius);
    default:
      return new Geom_ToroidalSurface(frame, found.radius, found.second);
  }
}

/// Cylindrical coordinates about an axis, in which a whole surface lies about the angle of pi.
struct AboutAxis {
  Eigen::Vector3d origin, x, y, z;
  double angle(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d way = point - origin;
    return std::atan2(y.dot(way), x.dot(way));
  }
};

double nearest_turn(double angle, double to) {
  return angle + full_turn * std::round((to - angle) / full_turn);
}

/// The new domain's point over one of the old domain, on the way there from the middle of the box.
class ToDomain {
 public:
  ToDomain(Handle(Geom_Surface) surface, const DomainBox& box, const Found& found, AboutAxis about)
      : surface_(std::move(surface)), box_(box), found_(found), about_(std::move(about)) {}

  Eigen::Vector2d operator()(const Eigen::Vector2d& uv) const {
    constexpr int steps = 24;
    const Eigen::Vector2d middle = (box_.low + box_.high) / 2;
    Eigen::Vector2d result(std::numbers::pi, 0);
    result.y() = second(at(middle));
    for (int i = 1; i <= steps; ++i) {
      const Eigen::Vector3d point = at(middle + double(i) / steps * (uv - middle));
      if (!is_pole(point)) result.x() = nearest_turn(about_.angle(point), result.x());
      const double other = second(point);
      result.y() = found_.kind == SurfaceKind::torus ? nearest_turn(other, result.y()) : other;
    }
    if (is_pole(at(uv))) result.x() = angle_at_pole(uv, result.x());
    return result;
  }

 private:
  bool is_pole(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d way = point - about_.origin;
    return !(std::hypot(about_.x.dot(way), about_.y.dot(way)) > 1e-9 * found_.radius);
  }

  /// That of the meridian on which the pole is reached.
  double angle_at_pole(const Eigen::Vector2d& uv, double near) const {
    for (const int d : {0, 1}) {
      Eigen::Vector2d inside = uv;
      inside[d] += 1e-3 * ((box_.low[d] + box_.high[d]) / 2 - uv[d]);
      if (!is_pole(at(inside))) return nearest_turn(about_.angle(at(inside)), near);
    }
    return near;
  }

  Eigen::Vector3d at(const Eigen::Vector2d& uv) const { return to_eigen(surface_->Value(uv.x(), uv.y())); }
  double second(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d way = point - about_.origin;
    const double height = about_.z.dot(way), radius = (way - height * about_.z).norm();
    switch (found_.kind) {
      case SurfaceKind::cylinder:
        return height;
      case SurfaceKind::cone:
        return height / std::cos(found_.second);
      case SurfaceKind::sphere:
        return std::atan2(height, radius);
      default:
        return std::atan2(height, radius - found_.radius);
    }
  }

  Handle(Geom_Surface) surface_;
  DomainBox box_;
  Found found_;
  AboutAxis about_;
};

std::optional<Found> found_form(const SurfaceSamples& samples, double tolerance) {
  for (const auto& find : {plane_of, sphere_of, cylinder_of, cone_of, torus_of})
    if (auto found = find(samples, tolerance)) return found;
  return std::nullopt;
}

}  // namespace

std::optional<SurfaceForm> surface_form(const Handle(Geom_Surface) & surface, const DomainBox& box,
                                        double tolerance) {
  const SurfaceSamples samples = samples_of(*surface, box);
  if (samples.points.cols() < form_samples || !(samples.size > 0)) return std::nullopt;
  std::optional<Found> found = found_form(samples, tolerance / samples.size);
  if (!found) return std::nullopt;
  found->origin = samples.mean + samples.size * found->origin;
  found->radius *= samples.size;
  if (found->kind == SurfaceKind::torus) found->second *= samples.size;
  if (found->kind == SurfaceKind::sphere) found->axis = sphere_axis(*surface, box, found->origin);
  const Eigen::Vector2d middle = (box.low + box.high) / 2;
  const Eigen::Vector3d point = to_eigen(surface->Value(middle.x(), middle.y()));
  Eigen::Vector3d away = point - found->origin;
  away -= found->axis * found->axis.dot(away);
  // The middle lies at half a turn, so that no face that does not go around crosses the seam.
  const bool is_plane = found->kind == SurfaceKind::plane;
  const Eigen::Vector3d x =
      is_plane || !(away.norm() > 0) ? any_across(found->axis) : Eigen::Vector3d(-away.normalized());
  const gp_Ax3 frame(to_point(found->origin), gp_Dir(found->axis.x(), found->axis.y(), found->axis.z()),
                     gp_Dir(x.x(), x.y(), x.z()));
  SurfaceForm result{made(*found, frame), {}, false};
  const AboutAxis about{found->origin, to_eigen(frame.XDirection()), to_eigen(frame.YDirection()),
                        to_eigen(frame.Direction())};
  if (is_plane)
    result.to_domain = [surface, about](const Eigen::Vector2d& uv) -> Eigen::Vector2d {
      const Eigen::Vector3d way = to_eigen(surface->Value(uv.x(), uv.y())) - about.origin;
      return {about.x.dot(way), about.y.dot(way)};
    };
  else
    result.to_domain = ToDomain(surface, box, *found, about);
  const Eigen::Vector2d there = result.to_domain(middle);
  const auto normal = [](const Geom_Surface& on, const Eigen::Vector2d& uv) {
    gp_Pnt p;
    gp_Vec u, v;
    on.D1(uv.x(), uv.y(), p, u, v);
    return to_eigen(u.Crossed(v));
  };
  result.turned = normal(*result.surface, there).dot(normal(*surface, middle)) < 0;
  return result;
}

}  // namespace isopatch::geometry
