#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// A direction along which a solid is a stack: each face is a floor across it, or a wall along it, upright or
/// inclined.
struct SweepFrame {
  Eigen::Vector3d origin, x, y, along;  ///< m; unit, right-handed: `along` is x cross y
  std::vector<FaceId> floors, walls;
  std::vector<FaceId> inclined;  ///< of the walls: drafts, chamfers, cones about the direction

  Eigen::Vector3d point(const Eigen::Vector2d& flat, double height) const {
    return origin + flat[0] * x + flat[1] * y + height * along;
  }
  Eigen::Vector2d flat(const Eigen::Vector3d& point) const {
    return {(point - origin).dot(x), (point - origin).dot(y)};
  }
  double height(const Eigen::Vector3d& point) const { return (point - origin).dot(along); }
};

/// Normals of plane faces, none twice in opposite directions.
std::vector<Eigen::Vector3d> floor_directions(const geometry::Brep& solid);

/// What keeps a solid from being a stack along a direction.
std::vector<FaceId> neither_floor_nor_wall(const geometry::Brep& solid, const Eigen::Vector3d& along);

/// All of them, none twice in opposite directions; empty for most solids.
/// @cost  a few evaluations of each face
std::vector<SweepFrame> sweep_frames(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
