#pragma once

#include <string>
#include <vector>

#include "segmentation/parameterization/hex_model.hpp"

namespace isopatch::app {

/// "face 4 of block 'part#2' meets part#3, part#4": of each T-joint the side and the blocks that lie at parts
/// of it; "face 4 of block 'part#2' meets part#3 in part" of sides of which neither lies within the other.
/// @cost  that of `overlapping_sides`
std::vector<std::string> t_joint_texts(const segmentation::HexModel& model);

}  // namespace isopatch::app
