#pragma once

#include <utility>
#include <vector>

#include "segmentation/parameterization/hex_model.hpp"

namespace isopatch::app {

/// Sides of two blocks that lie on one another in part, neither within the other: what the topology, which
/// knows whole sides and sides within sides, has nothing for.
///
/// They are found at 10 x 10 points of each side: what is narrower than a tenth of both may be missed.
/// @return  pairs in the order of the blocks
/// @cost  100 points of each side that is not joined to another as a whole; 0.1 ms a point
std::vector<std::pair<geometry::BlockSide, geometry::BlockSide>> overlapping_sides(
    const segmentation::HexModel& model);

}  // namespace isopatch::app
