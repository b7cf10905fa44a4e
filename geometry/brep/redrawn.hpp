#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <variant>

#include "geometry/topology/edge_use.hpp"

namespace isopatch::geometry {

/// Edges that are drawn otherwise: as lines between two points of the plane, m, or as another edge, turned
/// round if it is reversed.
using Redrawn = std::map<EdgeId, std::variant<std::array<Eigen::Vector3d, 2>, EdgeUse>>;

}  // namespace isopatch::geometry
