#include "segmentation/turned/internal/turned_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "segmentation/turned/internal/prism_walls.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Carrier;
using geometry::CurveKind;
using geometry::SurfaceKind;

constexpr double tau = 2 * std::numbers::pi;
/// Sine of the angle that counts as none: over the length of a part, 1e-7 of it.
constexpr double no_angle = 1e-7;

struct Axis {
  Eigen::Vector3d origin, direction;
};

double distance(const Axis& axis, const Eigen::Vector3d& point) {
  return (point - axis.origin).cross(axis.direction).norm();
}

bool is_one(const Axis& a, const Axis& b, double tolerance) {
  return a.direction.cross(b.direction).norm() < no_angle && distance(a, b.origin) < tolerance;
}

/// The axis of the circle through three points of an edge.
std::optional<Axis> axis_of(const Brep& solid, EdgeId edge) {
  const Eigen::Vector3d a = solid.point(edge, 0), b = solid.point(edge, 0.3), c = solid.point(edge, 0.65);
  const Eigen::Vector3d u = b - a, v = c - a, normal = u.cross(v);
  const double square = normal.squaredNorm();
  if (!(square > 1e-12 * u.squaredNorm() * v.squaredNorm())) return std::nullopt;
  return Axis{a + (u.squaredNorm() * v - v.squaredNorm() * u).cross(normal) / (2 * square),
              normal.normalized()};
}

/// Axes of cylinders, cones and tori, then of spheres, then of edges as if they were circles; none twice.
std::vector<Axis> possible_axes(const Brep& solid) {
  std::vector<Axis> result;
  const auto add = [&](const Axis& axis) {
    if (std::none_of(result.begin(), result.end(),
                     [&](const Axis& known) { return is_one(known, axis, 1e-7 * solid.size()); }))
      result.push_back(axis);
  };
  std::vector<Axis> spheres;
  for (std::size_t f = 0; f < solid.faces().size(); ++f) {
    const std::optional<Carrier> carrier = solid.carrier(FaceId(static_cast<int>(f)));
    if (!carrier || carrier->kind == SurfaceKind::plane) continue;
    const Axis axis{carrier->origin, carrier->axis};
    if (carrier->kind == SurfaceKind::sphere)
      spheres.push_back(axis);
    else
      add(axis);
  }
  // No face but these can be turned about another axis.
  if (!result.empty()) return {result.front()};
  for (const Axis& axis : spheres) add(axis);
  for (std::size_t e = 0; e < solid.edges().size(); ++e)
    if (solid.edges()[e].kind != CurveKind::line)
      if (const auto axis = axis_of(solid, EdgeId(static_cast<int>(e)))) add(*axis);
  return result;
}

enum class Part { turned, end, other };

/// Whether all normals meet the axis.
bool is_turned_surface(const Brep& solid, FaceId face, const Axis& axis) {
  const geometry::DomainBox domain = solid.domain(face);
  constexpr int samples = 9;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const Eigen::Vector2d share((i + 0.5) / samples, (j + 0.5) / samples);
      const Eigen::Vector2d uv = domain.low + (domain.high - domain.low).cwiseProduct(share);
      const Eigen::Vector3d around = axis.direction.cross(solid.point(face, uv) - axis.origin);
      if (!(std::abs(solid.outward_normal(face, uv).dot(around)) < no_angle * solid.size())) return false;
    }
  return true;
}

Part part_of(const Brep& solid, FaceId face, const Axis& axis) {
  const std::optional<Carrier> carrier = solid.carrier(face);
  if (!carrier) return is_turned_surface(solid, face, axis) ? Part::turned : Part::other;
  const double tolerance = 1e-7 * solid.size();
  const bool centred = distance(axis, carrier->origin) < tolerance;
  const bool along = carrier->axis.cross(axis.direction).norm() < no_angle;
  switch (carrier->kind) {
    case SurfaceKind::plane:
      if (along) return Part::turned;
      return std::abs(carrier->axis.dot(axis.direction)) < no_angle &&
                     std::abs((carrier->origin - axis.origin).dot(carrier->axis)) < tolerance
                 ? Part::end
                 : Part::other;
    case SurfaceKind::sphere:
      return centred ? Part::turned : Part::other;
    default:
      return centred && along ? Part::turned : Part::other;
  }
}

/// Finds the angles at which a solid that is turned by less than a whole turn begins and ends.
/// @return  false unless these are at two angles
bool find_ends(const Brep& solid, TurnedFrame& frame, const std::vector<FaceId>& ends) {
  std::optional<double> first, last;
  const auto enter = [](FaceId face, double angle, std::optional<double>& known, std::vector<FaceId>& faces) {
    if (known && std::cos(angle - *known) < 1 - 1e-9) return false;
    known = angle;
    if (faces.empty() || faces.back() != face) faces.push_back(face);
    return true;
  };
  for (const FaceId face : ends)
    for (const auto& loop : solid.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (const double t : {0.0, 0.3, 0.6, 0.9}) {
          const Eigen::Vector3d point = solid.point(use.edge, t);
          if (frame.flat(point)[0] < 1e-6 * solid.size()) continue;
          const double angle = frame.angle(point);
          const Eigen::Vector3d around = frame.along.cross(point - frame.origin);
          const bool begins = solid.outward_normal(face, solid.domain(face).low).dot(around) < 0;
          if (!enter(face, angle, begins ? first : last, begins ? frame.first : frame.last)) return false;
        }
  if (!first || !last) return false;
  frame.sweep = *last - *first - tau * std::floor((*last - *first) / tau);
  const Eigen::Vector3d x = std::cos(*first) * frame.x + std::sin(*first) * frame.y;
  frame.y = frame.along.cross(x);
  frame.x = x;
  return frame.sweep > no_angle;
}

/// Where a face begins that does not go all around, else any seam.
void turn_to_seams(const Brep& solid, TurnedFrame& frame) {
  std::optional<Eigen::Vector3d> seam;
  for (std::size_t e = 0; e < solid.edges().size(); ++e) {
    const geometry::BrepEdge& edge = solid.edges()[e];
    const Eigen::Vector3d middle = solid.point(EdgeId(static_cast<int>(e)), 0.37);
    const double radius = frame.flat(middle)[0];
    if (radius < 1e-6 * solid.size()) continue;
    const Eigen::Vector3d around = frame.along.cross(middle - frame.origin).normalized();
    const Eigen::Vector3d tangent = solid.tangent(EdgeId(static_cast<int>(e)), 0.37).normalized();
    if (std::abs(tangent.dot(around)) > 1e-6) continue;
    const bool divides = edge.faces.size() == 2 && edge.faces[0] != edge.faces[1];
    if (!seam || divides) seam = middle;
    if (divides) break;
  }
  if (!seam) return;
  const double angle = frame.angle(*seam);
  const Eigen::Vector3d x = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
  frame.y = frame.along.cross(x);
  frame.x = x;
}

/// Where the walls of prisms have their corners.
bool turn_to_prisms(const Brep& solid, TurnedFrame& frame) {
  const auto walls = prism_walls(solid, frame.origin, frame.along, frame.prisms);
  if (!walls) return false;
  frame.sides = walls->sides;
  frame.x = walls->corner;
  frame.y = frame.along.cross(frame.x);
  return true;
}

/// @param prismatic  whether it has walls of prisms
std::optional<TurnedFrame> frame_about(const Brep& solid, const Axis& axis, bool prismatic) {
  TurnedFrame frame;
  frame.origin = axis.origin;
  frame.along = axis.direction;
  Eigen::Index least = 0;
  axis.direction.cwiseAbs().minCoeff(&least);
  frame.x = axis.direction.cross(Eigen::Vector3d::Unit(least)).normalized();
  frame.y = frame.along.cross(frame.x);
  frame.sweep = tau;
  std::vector<FaceId> ends;
  for (std::size_t f = 0; f < solid.faces().size(); ++f) {
    const FaceId face(static_cast<int>(f));
    const Part part = part_of(solid, face, axis);
    if (part == Part::other && !prismatic) return std::nullopt;
    (part == Part::other ? frame.prisms : part == Part::end ? ends : frame.faces).push_back(face);
  }
  if (prismatic) return ends.empty() && turn_to_prisms(solid, frame) ? std::optional(frame) : std::nullopt;
  if (ends.empty())
    turn_to_seams(solid, frame);
  else if (!find_ends(solid, frame, ends))
    return std::nullopt;
  return frame;
}

}  // namespace

Eigen::Vector2d TurnedFrame::flat(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d way = point - origin;
  return {std::hypot(way.dot(x), way.dot(y)), way.dot(along)};
}

double TurnedFrame::angle(const Eigen::Vector3d& point) const {
  return std::atan2((point - origin).dot(y), (point - origin).dot(x));
}

Eigen::Vector3d TurnedFrame::point(const Eigen::Vector2d& flat, double angle) const {
  return origin + flat[0] * (std::cos(angle) * x + std::sin(angle) * y) + flat[1] * along;
}

geometry::NurbsCurve TurnedFrame::turned(const geometry::NurbsCurve& curve, double angle) const {
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, along).toRotationMatrix();
  return geometry::NurbsCurve(curve.knots(),
                              (rotation * (curve.control_points().colwise() - origin)).colwise() + origin,
                              curve.weights());
}

namespace {

std::optional<TurnedFrame> first_frame(const Brep& solid, bool prismatic) {
  for (const Axis& axis : possible_axes(solid))
    if (std::optional<TurnedFrame> frame = frame_about(solid, axis, prismatic)) return frame;
  return std::nullopt;
}

}  // namespace

std::optional<TurnedFrame> turned_frame(const Brep& solid) {
  return first_frame(solid, false);
}

std::optional<TurnedFrame> prismatic_frame(const Brep& solid) {
  return first_frame(solid, true);
}

}  // namespace isopatch::segmentation
