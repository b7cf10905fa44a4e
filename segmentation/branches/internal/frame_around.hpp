#pragma once

#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"

namespace isopatch::segmentation {

/// Adds quadrilaterals between a ring of edges and the four sides around it, which stay whole.
/// @param region   number of theirs
/// @param ring     edges, counterclockwise, each begins where the one before ends
/// @param drawing  its first four vertices are the corners, its first four edges the sides
/// @throws Error unsupported  the ring has an odd number of edges, or fewer than four
void add_frame(int region, const std::vector<int>& ring, Quadrangulation& drawing);

}  // namespace isopatch::segmentation
