#pragma once

#include <string>
#include <vector>

#include "segmentation/decomposition/combinatorics/internal/planar_map.hpp"

namespace isopatch::segmentation {

/// The least of the breadth-first descriptions that start at each dart: neighbours of each vertex in their
/// order around it, by the numbers that the search gives, and a mark after each.
/// @param map    a sphere of fewer than 65,000 vertices
/// @param kinds  of the darts, below 8, that are to count; or empty
/// @cost O(E) for each dart that the degrees, face sizes and kinds around do not rule out
std::u16string map_code(const PlanarMap& map, const Darts& around, const std::vector<char16_t>& kinds,
                        bool mirrored_too);

}  // namespace isopatch::segmentation
