#pragma once

#include <Eigen/Core>
#include <array>

#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// One of the eight corners of a patch, where a control point is a place of the body.
struct PatchCorner {
  PatchId patch;
  std::array<bool, 3> high = {false, false, false};  ///< at the high end of each direction
  auto operator<=>(const PatchCorner&) const = default;
};

/// All eight, the first direction fastest.
std::array<PatchCorner, 8> corners_of(PatchId patch);

/// Index of a corner among all control points of its patch.
int control_point_of(const std::array<int, 3>& sizes, const PatchCorner& corner);
/// Its node in a discretization.
int node_of(const Discretization& discretization, const PatchCorner& corner);
/// Where it is, m.
Eigen::Vector3d place_of(const Discretization& discretization, const PatchCorner& corner);

}  // namespace isopatch::iga
