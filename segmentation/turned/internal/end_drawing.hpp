#pragma once

#include <array>
#include <vector>

#include "segmentation/profiles/profile.hpp"
#include "segmentation/turned/internal/half_profile.hpp"

namespace isopatch::segmentation {

/// What is no whole turn begins with: its first end, in the half-plane at angle 0.
struct EndDrawing {
  geometry::Brep sheet;  ///< whose edges the half profile's curves are, by their numbers
  HalfProfile half;
  std::vector<ProfileRegion> regions;  ///< of edges that have the numbers of the half profile's curves
};

/// @param lines  in either end, m; drawn as well
/// @throws Error unsupported  the end is divided where no face is
EndDrawing end_drawing(const geometry::Brep& solid, const TurnedFrame& frame,
                       const std::vector<std::array<Eigen::Vector3d, 2>>& lines);

}  // namespace isopatch::segmentation
