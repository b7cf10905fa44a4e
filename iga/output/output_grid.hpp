#pragma once

#include <array>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::iga {

/// Into how many straight pieces each element of a patch is cut along each direction.
using ElementPieces = std::array<std::vector<int>, 3>;

/// Pieces of all patches for straight cells, equal on both sides of every interface.
///
/// An element has at least `least` pieces along a direction, and so many that none of 25 lines along it,
/// spread over the patch, turns by more than some 9 degrees in a piece: chords of a circle then lie within
/// 0.31 % of its radius, and a polygon's area within 0.41 % of the circle's. At most 32.
///
/// @param model    how the patches meet
/// @param patches  its patches in the solution space
/// @param least    1 .. 32
/// @throws Error invalid_argument  least out of range
/// @cost   100 points of each layer of elements
std::vector<ElementPieces> straight_pieces(const geometry::MultiPatch& model,
                                           const std::vector<geometry::NurbsVolume>& patches, int least);

/// The ends of the pieces, evenly spread over each element, both ends of the patch included.
geometry::GridParameters<3> grid_of(const geometry::NurbsVolume& patch, const ElementPieces& pieces);

}  // namespace isopatch::iga
