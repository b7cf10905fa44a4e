#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// A line, an arc or a spline in a plan, m.
struct PlanCurve {
  Eigen::Vector2d from, to;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of an arc
  double sweep = 0;                                  ///< rad, counterclockwise; 0: a line; 2 pi: a circle

  std::optional<geometry::NurbsCurve> spline = {};  ///< over [0, 1] in the plane z = 0

  bool is_straight() const { return sweep == 0 && !spline; }
  bool is_circle() const;
  /// At a share of its length, or of a spline's parameters; beyond 1 on circles.
  Eigen::Vector2d point(double share) const;
  /// Exact over [0, 1] in the plane z = 0, from one share to another.
  /// @throws Error unsupported  an arc of 170 degrees or more
  geometry::NurbsCurve piece(double low, double high) const;
  PlanCurve reversed() const;
};

}  // namespace isopatch::segmentation
