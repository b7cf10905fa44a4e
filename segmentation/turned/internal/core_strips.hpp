#pragma once

#include <optional>
#include <vector>

#include "segmentation/turned/internal/half_profile.hpp"
#include "segmentation/turned/internal/surfaces.hpp"

namespace isopatch::segmentation {

/// Of the smallest radius beside the axis: what an O-grid of a disc has.
constexpr double ordinary_core_share = 0.6;

/// Where a solid ends on its axis.
struct CoreEnd {
  int vertex = -1;                 ///< of the half profile: corner of the core on the surface
  std::optional<Spheroid> sphere;  ///< nothing: a plane
  double height = 0;               ///< on the axis, m
  std::vector<FaceId> faces;
};

/// A stretch of the axis inside the solid, with a square column around it.
struct CoreStrip {
  std::vector<int> line;  ///< curves of the half profile beside the column, from low to high
  CoreEnd low, high;
};

/// A half profile without what is nearest to the axis.
struct CoredProfile {
  HalfProfile outside;
  std::vector<CoreStrip> strips;
};

/// Takes strips along the axis off a half profile, as wide as a share of the smallest radius beside each. On
/// a sphere that turns far, a strip is as wide as the side of a cube would be.
/// @throws Error unsupported  the solid ends on its axis in something other than a plane, a sphere or an
/// ellipsoid, or has an edge there
CoredProfile without_cores(const geometry::Brep& solid, const TurnedFrame& frame, HalfProfile profile,
                           double share = ordinary_core_share);

}  // namespace isopatch::segmentation
