#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// A line about which a solid is turned: each face is a surface of revolution about it, or one of two plane
/// ends through it.
struct TurnedFrame {
  Eigen::Vector3d origin, x, y, along;  ///< m; unit, right-handed; angles count from x towards y
  double sweep;                         ///< rad, from x on; 2 pi of a whole turn
  std::vector<FaceId> faces;            ///< surfaces of revolution
  /// Ends at angle 0 and at `sweep`; none of a whole turn. A face that runs through the axis is both.
  std::vector<FaceId> first, last;
  /// Walls of regular prisms about the axis, with corners at angle 0, and how many a prism has: else none, 0.
  std::vector<FaceId> prisms;
  int sides = 0;

  bool is_whole() const { return first.empty(); }
  /// Distance from the axis and height along it, m.
  Eigen::Vector2d flat(const Eigen::Vector3d& point) const;
  /// In (-pi, pi].
  double angle(const Eigen::Vector3d& point) const;
  Eigen::Vector3d point(const Eigen::Vector2d& flat, double angle) const;
  geometry::NurbsCurve turned(const geometry::NurbsCurve& curve, double angle) const;
};

/// Nothing for a solid that is not turned.
/// @cost  a few evaluations of each face
std::optional<TurnedFrame> turned_frame(const geometry::Brep& solid);

/// Of a whole turn but for regular prisms about its axis, which all have as many sides: hexagonal sockets of
/// screws, square ends of shafts. Nothing where there is none.
/// @cost  as above
std::optional<TurnedFrame> prismatic_frame(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
