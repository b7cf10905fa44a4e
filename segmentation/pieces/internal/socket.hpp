#pragma once

#include <optional>
#include <vector>

#include "segmentation/pieces/internal/piece.hpp"
#include "segmentation/sweeps/stack.hpp"

namespace isopatch::segmentation {

/// A box on one side of which something round stands: that side has a disc that a cut has made.
struct Socket {
  geometry::PlaneSurface top;    ///< looks out, its origin in the middle of the disc
  Eigen::Vector2d low, high;     ///< corners of that side, along the plane's x and y, m
  double depth = 0, radius = 0;  ///< m
};

/// @return  nothing for a piece that is none
std::optional<Socket> socket_of(const Piece& piece);

/// Its hexahedra: the disc in a core and a ring around it, which both end inside the box as cups, so that
/// nothing of the disc is seen on its other sides.
/// @param lines  on the other sides; those that run all through the one opposite to the disc, along its x or
/// y, go on through the box
/// @throws Error unsupported  a line elsewhere, or lines in both directions
geometry::CellComplex socket_cells(const Piece& piece, const Socket& socket, const std::vector<Line>& lines);

}  // namespace isopatch::segmentation
