#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <variant>

#include "geometry/topology/edge_use.hpp"

namespace isopatch::geometry {

/// Larger or smaller about a point of the plane, m.
struct Scaled {
  Eigen::Vector3d centre;
  double factor;
};

/// Edges that are drawn otherwise: as lines between two points of the plane, m, as another edge, turned round
/// if it is reversed, or in another size.
using Redrawn = std::map<EdgeId, std::variant<std::array<Eigen::Vector3d, 2>, EdgeUse, Scaled>>;

}  // namespace isopatch::geometry
