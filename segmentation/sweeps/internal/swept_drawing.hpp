#pragma once

#include <array>
#include <optional>
#include <vector>

#include "segmentation/profiles/profile.hpp"
#include "segmentation/sweeps/internal/tracks.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

/// Material between two floors.
struct Slab {
  double low, high;                   ///< heights along the sweep, m
  std::optional<FaceId> bottom, top;  ///< of the solid, where it ends there
};

/// A stack as seen along its direction: the outlines of all its floors over each other, inclined walls where
/// they are lowest.
struct SweptDrawing {
  Tracks tracks;
  geometry::Brep sheet;  ///< edges and faces by the numbers of the profile's edges and regions
  Profile profile;       ///< in the frame's x and y, m
  std::vector<std::vector<Slab>> slabs;  ///< by region, from low to high
};

/// @param lines  on floors, m: drawn as well
/// @throws Error unsupported  floors that do not bound material by turns: the solid is no such stack
SweptDrawing swept_drawing(const geometry::Brep& solid, const SweepFrame& frame,
                           const std::vector<std::array<Eigen::Vector3d, 2>>& lines = {});

}  // namespace isopatch::segmentation
