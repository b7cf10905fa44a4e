#pragma once

#include <vector>

#include "segmentation/sweeps/internal/fillet_rings.hpp"

namespace isopatch::segmentation {

/// Divides rings along their edges.
/// @param share  of the ring's width that the outer half gets
/// @throws Error unsupported  where a divided ring meets one that is not
void divide_rings(FilletRings& rings, const std::vector<int>& edges, double share);

}  // namespace isopatch::segmentation
