#pragma once

#include <optional>
#include <vector>

#include "segmentation/pieces/pieced_cells.hpp"

namespace isopatch::segmentation {

/// Divides a solid that becomes stacks and turned pieces when planes cut it, each piece by itself: hexahedra
/// of different pieces meet in parts of their sides (T-joints).
/// @param cuts     planes by which it is cut first
/// @param seconds  of the processor, after which no further planes are tried
/// @return  of the ways with the fewest cuts that of the fewest hexahedra; nothing where no such pieces were
/// found
/// @throws Error invalid_argument  a plane that does not cut the solid, by its number
/// @throws Error unsupported  a piece that cannot be divided: says where
/// @cost  as `pieced_cells`, without making pieces meet
std::optional<PiecedCells> pieces_apart(const geometry::Brep& solid,
                                        const std::vector<geometry::PlaneSurface>& cuts = {},
                                        double seconds = 15);

}  // namespace isopatch::segmentation
