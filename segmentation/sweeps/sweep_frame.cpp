#include "segmentation/sweeps/sweep_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Carrier;
using geometry::SurfaceKind;

/// Sine of the angle that counts as none: over the length of a part, 1e-7 of it.
constexpr double straight = 1e-7;

bool is_along(const Eigen::Vector3d& axis, const Eigen::Vector3d& along) {
  return axis.cross(along).norm() < straight;
}

/// Walls may lean over by so much: the corners of blocks between them and floors are then 20 degrees at
/// least.
constexpr double largest_slope = 0.94;

enum class Part { floor, upright, inclined, other };

/// By the largest slope of its normals.
Part part_of_surface(const Brep& solid, FaceId face, const Eigen::Vector3d& along) {
  const geometry::DomainBox domain = solid.domain(face);
  double slope = 0;
  constexpr int samples = 9;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const Eigen::Vector2d share((i + 0.5) / samples, (j + 0.5) / samples);
      const Eigen::Vector2d uv = domain.low + (domain.high - domain.low).cwiseProduct(share);
      slope = std::max(slope, std::abs(solid.outward_normal(face, uv).dot(along)));
    }
  return slope < straight ? Part::upright : slope < largest_slope ? Part::inclined : Part::other;
}

Part part_of(const Brep& solid, FaceId face, const Eigen::Vector3d& along) {
  const std::optional<Carrier> carrier = solid.carrier(face);
  if (!carrier) return part_of_surface(solid, face, along);
  const double slope = std::abs(carrier->axis.dot(along));
  switch (carrier->kind) {
    case SurfaceKind::plane:
      return is_along(carrier->axis, along) ? Part::floor
             : slope < straight             ? Part::upright
             : slope < largest_slope        ? Part::inclined
                                            : Part::other;
    case SurfaceKind::cylinder:
      return is_along(carrier->axis, along) ? Part::upright : Part::other;
    case SurfaceKind::cone:
      return is_along(carrier->axis, along) &&
                     std::abs(std::sin(carrier->half_angle.radians())) < largest_slope
                 ? Part::inclined
                 : Part::other;
    default:
      return Part::other;
  }
}

std::optional<SweepFrame> frame_along(const Brep& solid, const Eigen::Vector3d& along) {
  SweepFrame frame;
  frame.along = along;
  // Axes of the model where they can be: figures stay round.
  Eigen::Index least = 0;
  along.cwiseAbs().minCoeff(&least);
  frame.x = Eigen::Vector3d::Unit(least).cross(along).cross(along).normalized();
  frame.x *= frame.x[least] < 0 ? -1 : 1;
  frame.y = along.cross(frame.x);
  for (std::size_t f = 0; f < solid.faces().size(); ++f) {
    const FaceId face(static_cast<int>(f));
    const Part part = part_of(solid, face, along);
    if (part == Part::other) return std::nullopt;
    (part == Part::floor ? frame.floors : frame.walls).push_back(face);
    if (part == Part::inclined) frame.inclined.push_back(face);
  }
  if (frame.floors.size() < 2) return std::nullopt;
  frame.origin = solid.carrier(frame.floors.front())->origin;
  return frame;
}

}  // namespace

std::vector<Eigen::Vector3d> floor_directions(const Brep& solid) {
  std::vector<Eigen::Vector3d> result;
  for (std::size_t f = 0; f < solid.faces().size(); ++f) {
    const std::optional<Carrier> carrier = solid.carrier(FaceId(static_cast<int>(f)));
    if (!carrier || carrier->kind != SurfaceKind::plane) continue;
    if (std::none_of(result.begin(), result.end(),
                     [&](const Eigen::Vector3d& known) { return is_along(carrier->axis, known); }))
      result.push_back(carrier->axis);
  }
  return result;
}

std::vector<FaceId> neither_floor_nor_wall(const Brep& solid, const Eigen::Vector3d& along) {
  std::vector<FaceId> result;
  for (std::size_t f = 0; f < solid.faces().size(); ++f)
    if (const FaceId face(static_cast<int>(f)); part_of(solid, face, along) == Part::other)
      result.push_back(face);
  return result;
}

std::vector<SweepFrame> sweep_frames(const Brep& solid) {
  std::vector<SweepFrame> result;
  for (const Eigen::Vector3d& along : floor_directions(solid))
    if (std::optional<SweepFrame> frame = frame_along(solid, along)) result.push_back(std::move(*frame));
  return result;
}

}  // namespace isopatch::segmentation
