#pragma once

#include <functional>
#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/sweeps/internal/merged_profile.hpp"
#include "segmentation/sweeps/internal/swept_drawing.hpp"

namespace isopatch::segmentation {

/// A drawing and its quadrilaterals.
struct DividedDrawing {
  SweptDrawing drawing;
  Quadrangulation quads;
};

/// What is divided in place of a drawing's profile: the same edges in slightly other places.
using AsDivided = std::function<Profile(const SweptDrawing&)>;

/// Divides the drawing of a stack; one that is symmetric about lines and has no inclined walls as a whole and
/// by halves and a quarter that are mirrored, of which it takes the one with the fewest quadrilaterals, where
/// they are good.
/// @param lines  on floors, m: drawn as well; with them the whole is divided
/// @throws Error unsupported  no stack, or its drawing cannot be divided: names the place
DividedDrawing divided_drawing(const geometry::Brep& solid, const SweepFrame& frame,
                               const std::vector<std::array<Eigen::Vector3d, 2>>& lines,
                               const QuadrangulationOptions& options, const AsDivided& as_divided = {});

/// Divides a drawing of which some regions are one.
/// @param merged  of its profile
/// @throws Error as above
DividedDrawing divided_drawing(const geometry::Brep& solid, const SweepFrame& frame, SweptDrawing drawing,
                               const MergedProfile& merged, const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation
