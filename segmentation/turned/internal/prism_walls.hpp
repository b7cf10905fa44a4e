#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// Plane walls of regular prisms about an axis: sockets for keys, square and hexagonal holes and ends.
struct PrismWalls {
  int sides;               ///< 4, 6, 8 or 12
  Eigen::Vector3d corner;  ///< from the axis to a corner, unit
};

/// Which regular prisms some faces are the walls of: all have as many sides, and corners at the same angles.
/// @param along  of the axis, unit
/// @return  nothing if one is no rectangle along the axis, or one of a prism is not there
std::optional<PrismWalls> prism_walls(const geometry::Brep& solid, const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& along, const std::vector<FaceId>& faces);

}  // namespace isopatch::segmentation
