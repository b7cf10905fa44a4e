#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"
#include "segmentation/sweeps/swept_columns.hpp"

namespace isopatch::segmentation {

/// A solid that would be a stack if cones about its direction did not cut off its walls: nuts and heads of
/// bolts. A cone is laid on the drawing as a level floor would be, columns under it end on it. All edges are
/// exact; the cone's faces follow it to 1e-9 of their size.
/// @return  nothing for a solid that is none
/// @throws Error unsupported  it cannot be divided, or the columns are not all of it
std::optional<SweptCells> roofed_cells(const geometry::Brep& solid, const QuadrangulationOptions& options);

/// Whether cones cut off walls along a direction.
bool has_roofs(const geometry::Brep& solid, const SweepFrame& frame);

/// Along a direction that has roofs, with lines on floors, and heights that columns are divided at, m.
/// @throws Error unsupported  as above
SweptCells roofed_cells_with(const geometry::Brep& solid, const SweepFrame& frame,
                             const std::vector<std::array<Eigen::Vector3d, 2>>& lines,
                             const std::vector<double>& heights);

}  // namespace isopatch::segmentation
