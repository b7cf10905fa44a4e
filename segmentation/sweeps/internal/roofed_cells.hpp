#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/sweeps/swept_columns.hpp"

namespace isopatch::segmentation {

/// A solid that would be a stack if cones about its direction did not cut off its walls: nuts and heads of
/// bolts. A cone is laid on the drawing as a level floor would be, columns under it end on it. All edges are
/// exact; the cone's faces follow it to 1e-9 of their size.
/// @return  nothing for a solid that is none
/// @throws Error unsupported  it cannot be divided, or the columns are not all of it
std::optional<SweptCells> roofed_cells(const geometry::Brep& solid, const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation
