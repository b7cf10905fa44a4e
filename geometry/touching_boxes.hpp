#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

namespace isopatch::geometry {

/// Pairs of boxes no further apart than `distance`, each with the smaller index first, in the order in which
/// they begin along x.
/// @cost  O(n log n) plus the pairs that overlap along x
std::vector<std::pair<std::size_t, std::size_t>> touching_boxes(const std::vector<Eigen::AlignedBox3d>& boxes,
                                                                double distance);

}  // namespace isopatch::geometry
