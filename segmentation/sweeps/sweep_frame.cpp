#include "segmentation/sweeps/internal/sweep_frame.hpp"

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

/// Directions in which walls or floors may lie, each once.
std::vector<Eigen::Vector3d> directions(const Brep& solid) {
  std::vector<Eigen::Vector3d> result;
  for (std::size_t f = 0; f < solid.faces().size(); ++f) {
    const std::optional<Carrier> carrier = solid.carrier(FaceId(static_cast<int>(f)));
    if (!carrier || carrier->kind != SurfaceKind::plane) continue;
    if (std::none_of(result.begin(), result.end(), [&](const Eigen::Vector3d& known) {
          return known.cross(carrier->axis).norm() < straight;
        }))
      result.push_back(carrier->axis);
  }
  return result;
}

bool is_floor(const std::optional<Carrier>& carrier, const Eigen::Vector3d& along) {
  return carrier && carrier->kind == SurfaceKind::plane && carrier->axis.cross(along).norm() < straight;
}

/// Walls may lean over by so much: the corners of blocks between them and floors are then 20 degrees at
/// least.
constexpr double largest_slope = 0.94;

bool is_inclined(const std::optional<Carrier>& carrier, const Eigen::Vector3d& along) {
  if (!carrier) return true;  // how far, and whether it is straight, is looked at when it is cut
  if (carrier->kind == SurfaceKind::plane) return std::abs(carrier->axis.dot(along)) < largest_slope;
  return carrier->kind == SurfaceKind::cone && carrier->axis.cross(along).norm() < straight &&
         std::abs(std::sin(carrier->half_angle.radians())) < largest_slope;
}

bool is_upright(const Brep& solid, FaceId face, const std::optional<Carrier>& carrier,
                const Eigen::Vector3d& along) {
  if (carrier && carrier->kind == SurfaceKind::plane) return std::abs(carrier->axis.dot(along)) < straight;
  if (carrier && carrier->kind == SurfaceKind::cylinder) return carrier->axis.cross(along).norm() < straight;
  if (carrier) return false;
  const geometry::DomainBox domain = solid.domain(face);
  constexpr int samples = 9;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const Eigen::Vector2d share((i + 0.5) / samples, (j + 0.5) / samples);
      const Eigen::Vector2d uv = domain.low + (domain.high - domain.low).cwiseProduct(share);
      if (std::abs(solid.outward_normal(face, uv).dot(along)) > straight) return false;
    }
  return true;
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
    const std::optional<Carrier> carrier = solid.carrier(face);
    if (is_floor(carrier, along))
      frame.floors.push_back(face);
    else
      frame.walls.push_back(face);
    if (is_floor(carrier, along) || is_upright(solid, face, carrier, along)) continue;
    if (!is_inclined(carrier, along)) return std::nullopt;
    frame.inclined.push_back(face);
  }
  if (frame.floors.size() < 2) return std::nullopt;
  frame.origin = solid.carrier(frame.floors.front())->origin;
  return frame;
}

}  // namespace

std::vector<SweepFrame> sweep_frames(const Brep& solid) {
  std::vector<SweepFrame> result;
  for (const Eigen::Vector3d& along : directions(solid))
    if (std::optional<SweepFrame> frame = frame_along(solid, along)) result.push_back(std::move(*frame));
  return result;
}

}  // namespace isopatch::segmentation
