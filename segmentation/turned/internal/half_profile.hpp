#pragma once

#include <optional>
#include <vector>

#include "segmentation/turned/internal/turned_frame.hpp"

namespace isopatch::segmentation {

/// An arc about a point of the axis, by angles from the axis: what a sphere shows, whose own seam may lie
/// anywhere.
struct PolarArc {
  double height, radius;  ///< of the centre, m
  double from, to;        ///< rad, in [0, pi]
  Eigen::Vector2d point(double share) const;
};

/// A curve of a half profile: a piece of an edge of the solid that lies in a half-plane of the axis, an arc,
/// or straight.
struct HalfCurve {
  int start = -1, end = -1;     ///< vertices; -1: closed on itself
  std::optional<EdgeId> edge;   ///< if it is one
  std::optional<PolarArc> arc;  ///< if it is one; neither: straight from start to end
  double angle = 0;             ///< of the edge's half-plane, rad
  double low = 0, high = 1;     ///< of the edge's t, or shares of the arc
  std::vector<FaceId> faces;    ///< of the solid that it sweeps; none inside
  bool of_prism = false;        ///< a corner of a prism: straight between meridians, not turned
};

/// What a turned solid shows in a half-plane of its axis: x is the distance from the axis, y the height, m.
struct HalfProfile {
  std::vector<Eigen::Vector2d> vertices;
  std::vector<HalfCurve> curves;
};

/// Of all faces of a whole turn; whatever lies in several half-planes is there once.
/// @throws Error unsupported  a face without an edge in a half-plane of the axis, naming it
HalfProfile half_profile(const geometry::Brep& solid, const TurnedFrame& frame);

Eigen::Vector2d point(const geometry::Brep& solid, const TurnedFrame& frame, const HalfProfile& profile,
                      const HalfCurve& curve, double share);
bool is_straight(const geometry::Brep& solid, const HalfCurve& curve);

/// A piece of it, in the half-plane at angle 0, as an exact curve over [0, 1].
/// @param low, high  shares of it
geometry::NurbsCurve piece_of_half_curve(const geometry::Brep& solid, const TurnedFrame& frame,
                                         const HalfCurve& curve, double low, double high);

}  // namespace isopatch::segmentation
