#pragma once

#include <vector>

#include "segmentation/pieces/internal/piece.hpp"
#include "segmentation/sweeps/stack.hpp"

namespace isopatch::segmentation {

/// Two pieces that meet in a plane.
struct Meeting {
  geometry::PlaneSurface plane;  ///< its x runs along a piece of which it is a wall
  int first, second;             ///< numbers of the pieces
};

/// Where pieces meet.
/// @throws Error unsupported  a plane across the direction of both pieces, or in which their directions are
/// at no right angle
std::vector<Meeting> meetings(const std::vector<Piece>& pieces);

/// Stacks of all pieces, divided so that their hexahedra meet in whole sides. Pieces of which a plane is a
/// wall come first: those that meet them with a floor take their sides over into their drawings.
/// @param pieces  must outlive the result
/// @throws Error unsupported  a drawing that cannot be divided, pieces that need no end of divisions
std::vector<Stack> met_stacks(const std::vector<Piece>& pieces);

}  // namespace isopatch::segmentation
