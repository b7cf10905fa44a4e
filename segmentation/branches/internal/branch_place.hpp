#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "segmentation/branches/internal/plan_drawing.hpp"

namespace isopatch::segmentation {

/// Where a branch grows out of a divided body.
struct BranchPlace {
  std::array<Eigen::Vector3d, 4> corners;  ///< of the outer side that it begins on, m
  std::vector<double> floor_radii;         ///< of layers of the body that become floors, in their order
  std::optional<double> top;               ///< height up to which it is made; nothing: it does not stand out
  std::vector<PlanQuad> on_top;            ///< how that is divided which stands on its top; empty: nothing
};

}  // namespace isopatch::segmentation
