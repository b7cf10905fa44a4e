#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// A surface through a closed loop of curves, m. Its domain is a plane that the loop is near to, as seen
/// along its normal, m: what is straight in space is straight there.
struct LoopSurface {
  NurbsSurface surface;          ///< cubic; the loop runs counter-clockwise around it
  Eigen::Vector3d origin, x, y;  ///< of the plane; two unit directions at right angles
  double deviation = 0;          ///< largest found between loop and surface, m

  Eigen::Vector2d domain_point(const Eigen::Vector3d& p) const {
    return {(p - origin).dot(x), (p - origin).dot(y)};
  }
};

/// A curve by its points, m; over [0, 1].
using LoopSegment = std::function<Eigen::Vector3d(double)>;

/// The smooth surface of little bending through a closed loop, where it has one over a plane.
/// @param loop       three curves or more, each starts where the one before ends
/// @param tolerance  m, that knots are added for, up to 24 spans each way
/// @return  the nearest found; nothing where the loop, seen along the normal of its plane, touches itself
/// @cost  three sparse systems of some hundred unknowns at most
std::optional<LoopSurface> loop_surface(const std::vector<LoopSegment>& loop, double tolerance);

}  // namespace isopatch::geometry
