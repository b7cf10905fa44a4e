#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/sweeps/swept_columns.hpp"

namespace isopatch::segmentation {

/// A solid that would be a stack without its rounds between floors and upright walls: it is divided
/// without them, a ring of quadrilaterals as wide as the round is put around each outline under one, and what
/// was the sharp edge moves to the middle of the round, whose lower half becomes a part of the floor and
/// whose upper half one of the wall. On rims the hexahedron at the sharp edge is left out, and its neighbours
/// meet instead. All of it is exact.
/// @return  nothing for a solid that is none
/// @throws Error unsupported  it cannot be divided, or its rounds cannot be put back: names the place
std::optional<SweptCells> filleted_cells(const geometry::Brep& solid, const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation
