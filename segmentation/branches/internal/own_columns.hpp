#pragma once

#include <vector>

#include "segmentation/branches/internal/cross_bores.hpp"
#include "segmentation/sweeps/stack.hpp"

namespace isopatch::segmentation {

/// Lines of a stack's drawing that bound a column for each bore across.
struct OwnColumns {
  std::vector<Line> lines;  ///< m; spokes of bores that end in one along the stack among them
  bool end_at_corners =
      true;  ///< of walls, where these have edges along the stack, on both sides of every bore
};

/// Columns from the wall that a bore opens in to the next, and no further; where a corner of one of these
/// walls is near, from there. So outlines that are round beyond are not cut at an acute angle.
/// @param blank  the stack without the bores
/// @throws Error unsupported  a wall that is too near beside a bore: names it
OwnColumns own_columns(const geometry::Brep& solid, const geometry::Brep& blank, const SweepFrame& frame,
                       const std::vector<CrossBore>& bores);

}  // namespace isopatch::segmentation
