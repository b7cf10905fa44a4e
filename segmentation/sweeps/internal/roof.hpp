#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

/// A cone about the direction of a stack that cuts off what is upright there, as the chamfer of a nut does:
/// its edges are circles across the direction and curves in upright planes. It is seen as a floor that is not
/// level.
class Roof {
 public:
  Roof(const geometry::Brep& solid, const SweepFrame& frame, FaceId face);

  FaceId face() const { return face_; }
  bool looks_up() const { return looks_up_; }
  /// Of the circle where it meets a level floor: the highest of one that looks up, m.
  double top() const { return top_; }
  /// Over a place of the drawing, m.
  double height(const Eigen::Vector2d& flat) const;
  /// Of the circle at its top, m.
  double radius() const { return (top_ - apex_) / slope_; }
  const Eigen::Vector2d& centre() const { return centre_; }
  /// Places of the drawing where two upright planes meet below it.
  std::vector<Eigen::Vector2d> corners(const geometry::Brep& solid) const;
  /// What lies over a curve of the drawing at any height: exact over lines, and over arcs about the axis.
  geometry::NurbsCurve lifted(const geometry::NurbsCurve& plan) const;

 private:
  geometry::NurbsCurve conic(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  SweepFrame frame_;
  FaceId face_;
  bool looks_up_ = false;
  double top_ = 0, apex_ = 0;  // heights
  double slope_ = 0;           // height by distance from the axis
  Eigen::Vector2d centre_;
};

/// The inclined faces of a stack that are such cones.
std::vector<FaceId> roofs(const geometry::Brep& solid, const SweepFrame& frame);

}  // namespace isopatch::segmentation
