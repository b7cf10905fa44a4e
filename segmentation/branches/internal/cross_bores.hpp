#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/branches/internal/inserted_branch.hpp"

namespace isopatch::segmentation {

/// A bore across the direction of a stack, with its counterbores.
struct CrossBore {
  std::vector<FaceId> faces;            ///< all of it
  FaceId opening;                       ///< a plane of the stack that it begins on
  std::vector<geometry::Carrier> ends;  ///< of the other faces that it meets
  double radius = 0;                    ///< the largest, m
  Branch branch;  ///< seen from the opening, x along the stack, its origin on the bore's axis
};

/// All faces of a solid that keep it from being a stack along a direction, if they are such bores: wide ones
/// first. Bores that cross are two where one interrupts the other.
/// @return  nothing if other faces are among them, or none is there
/// @throws Error unsupported  one that opens in no plane across it: names it
std::optional<std::vector<CrossBore>> cross_bores(const geometry::Brep& solid, const Eigen::Vector3d& along);

}  // namespace isopatch::segmentation
