#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// What keeps a solid from being a stack along a direction.
struct InTheWay {
  Eigen::Vector3d along;
  std::vector<FaceId> faces;  ///< neither across the direction nor along it, nor inclined walls
};

/// Of the normals of plane faces the one with the fewest faces in the way; nothing for solids without plane
/// faces.
/// @cost  a few evaluations of each face for each direction
std::optional<InTheWay> least_in_the_way(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
