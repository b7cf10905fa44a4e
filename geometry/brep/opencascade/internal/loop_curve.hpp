#pragma once

#include <Eigen/Core>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Surface.hxx>

namespace isopatch::geometry {

/// A curve of a loop of a trimmed surface, alone: t in [0, 1] along it.
class LoopCurve {
 public:
  LoopCurve(Handle(Geom_Surface) surface, Handle(Geom2d_BSplineCurve) curve);

  Eigen::Vector2d domain_point(double t) const;
  Eigen::Vector3d point(double t) const;
  const Handle(Geom2d_BSplineCurve) & curve() const { return curve_; }
  const Handle(Geom_Surface) & surface() const { return surface_; }
  /// Of a chain of chords.
  double length() const;
  /// The t of the nearest point.
  double nearest(const Eigen::Vector3d& target) const;

  /// The curve over [first, last] instead, reversed if asked for.
  Handle(Geom2d_BSplineCurve) over(double first, double last, bool reversed) const;

 private:
  static constexpr int samples = 128;
  Handle(Geom_Surface) surface_;
  Handle(Geom2d_BSplineCurve) curve_;
  Eigen::Matrix3Xd points_;
};

/// How well a second curve agrees with a first one in space.
struct CurveMatch {
  double distance = 0;    ///< largest, from points of the first to the second
  bool reversed = false;  ///< the second runs the other way
};
CurveMatch match(const LoopCurve& first, const LoopCurve& second);

/// A curve in the second one's domain that at t is nearest to the first one's point at t; over [first, last].
struct FollowingCurve {
  Handle(Geom2d_BSplineCurve) curve;
  double distance = 0;  ///< largest between the two in space at the same t
};
/// @param enough  distance at which the search for a better one ends
FollowingCurve follow(const LoopCurve& leader, const LoopCurve& follower, const CurveMatch& match,
                      double first, double last, double enough);

}  // namespace isopatch::geometry
