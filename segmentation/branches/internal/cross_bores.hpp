#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/branches/internal/inserted_branch.hpp"

namespace isopatch::segmentation {

/// A bore across the direction of a stack, with its counterbores, a slot of any outline, or a round boss with
/// whatever is turned about its axis on it and in it.
struct CrossBore {
  std::vector<FaceId> faces;            ///< all of it
  std::optional<FaceId> opening;        ///< a plane of the stack that it begins on; nothing: other walls
  std::vector<geometry::Carrier> ends;  ///< of the other faces that it meets
  double radius = 0;  ///< the largest, or half of what a slot is wide where it is widest along or across
                      ///< the stack, whichever is less, m
  Eigen::Vector2d low, high;  ///< of what it takes in its view, m
  bool is_slot = false, is_boss = false;
  Branch branch;  ///< seen from the opening, x along the stack, its origin on the axis or in the middle
};

/// All faces of a solid that keep it from being a stack along a direction, if they are such bores, slots and
/// bosses: wide ones first. Bores that cross are two where one interrupts the other. Slots are walls between
/// edges along them, all around.
/// @return  nothing if other faces are among them, bosses that stand on no plane across them, or none is
/// there
/// @throws Error unsupported  one that is open along its whole length, or opens in no wall, a boss with other
/// than walls and floors at its foot and below: names it
std::optional<std::vector<CrossBore>> cross_bores(const geometry::Brep& solid, const Eigen::Vector3d& along);

}  // namespace isopatch::segmentation
