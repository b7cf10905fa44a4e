#include "segmentation/turned/internal/prism_walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// A rectangle across the way from the axis.
struct PrismWall {
  Eigen::Vector3d out;  ///< from the axis, unit
  double distance, half_width;
  double low, high;  ///< along the axis
};

/// Relative to what is measured.
constexpr double alike = 1e-6;

bool is_corner(const PrismWall& wall, double aside, double height, double tolerance) {
  return std::abs(std::abs(aside) - wall.half_width) < tolerance &&
         std::min(std::abs(height - wall.low), std::abs(height - wall.high)) < tolerance;
}

/// Nothing for what is no rectangle along the axis with its middle across from it.
std::optional<PrismWall> wall_of(const Brep& solid, FaceId face, const Eigen::Vector3d& origin,
                                 const Eigen::Vector3d& along) {
  const auto carrier = solid.carrier(face);
  if (!carrier || carrier->kind != geometry::SurfaceKind::plane ||
      std::abs(carrier->axis.dot(along)) > 1e-7 || solid.face(face).loops.size() != 1)
    return std::nullopt;
  const double distance = (carrier->origin - origin).dot(carrier->axis);
  const Eigen::Vector3d out = distance < 0 ? Eigen::Vector3d(-carrier->axis) : carrier->axis;
  const Eigen::Vector3d aside = along.cross(out);
  PrismWall wall{out, std::abs(distance), 0, 1e300, -1e300};
  std::vector<Eigen::Vector2d> corners;
  for (const geometry::EdgeUse& use : solid.face(face).loops.front()) {
    if (solid.edge(use.edge).kind != geometry::CurveKind::line) return std::nullopt;
    const Eigen::Vector3d way = solid.vertex(solid.edge(use.edge).start) - origin,
                          other = solid.vertex(solid.edge(use.edge).end) - origin;
    for (const Eigen::Vector3d& end : {way, other}) {
      corners.emplace_back(end.dot(aside), end.dot(along));
      wall.half_width = std::max(wall.half_width, std::abs(corners.back().x()));
      wall.low = std::min(wall.low, corners.back().y());
      wall.high = std::max(wall.high, corners.back().y());
    }
  }
  const double tolerance = alike * wall.half_width;
  for (const Eigen::Vector2d& corner : corners)
    if (!is_corner(wall, corner.x(), corner.y(), tolerance)) return std::nullopt;
  return wall;
}

/// Of the regular prism that a wall looks like a side of; nothing where that has another number.
std::optional<int> sides_of(const PrismWall& wall) {
  if (!(wall.distance > 0)) return std::nullopt;
  const double half = std::atan2(wall.half_width, wall.distance);
  for (const int sides : {4, 6, 8, 12})
    if (std::abs(half * sides / std::numbers::pi - 1) < alike) return sides;
  return std::nullopt;
}

bool is_of_one_prism(const PrismWall& a, const PrismWall& b) {
  const double tolerance = alike * a.half_width;
  return std::abs(a.distance - b.distance) < tolerance && std::abs(a.low - b.low) < tolerance &&
         std::abs(a.high - b.high) < tolerance;
}

}  // namespace

std::optional<PrismWalls> prism_walls(const Brep& solid, const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& along, const std::vector<FaceId>& faces) {
  std::vector<PrismWall> walls;
  std::optional<int> sides;
  for (const FaceId face : faces) {
    const std::optional<PrismWall> wall = wall_of(solid, face, origin, along);
    const std::optional<int> of_wall = wall ? sides_of(*wall) : std::nullopt;
    if (!of_wall || (sides && *sides != *of_wall)) return std::nullopt;
    sides = of_wall;
    walls.push_back(*wall);
  }
  if (!sides) return std::nullopt;
  const double turn = 2 * std::numbers::pi / *sides;
  const Eigen::Vector3d &first = walls.front().out, across = along.cross(first);
  for (const PrismWall& wall : walls) {
    const double steps = std::atan2(wall.out.dot(across), wall.out.dot(first)) / turn;
    const auto of_its_prism = std::count_if(
        walls.begin(), walls.end(), [&](const PrismWall& other) { return is_of_one_prism(wall, other); });
    if (std::abs(steps - std::round(steps)) > alike || of_its_prism != *sides) return std::nullopt;
  }
  return PrismWalls{*sides, std::cos(turn / 2) * first + std::sin(turn / 2) * across};
}

}  // namespace isopatch::segmentation
