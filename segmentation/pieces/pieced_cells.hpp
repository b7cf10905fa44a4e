#pragma once

#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// A solid as stacks of several directions and turned pieces that meet side to side.
struct PiecedCells {
  struct Piece {
    Eigen::Vector3d along;  ///< unit; the axis of one that is turned
    bool turned = false;
    int hexahedra = 0;
  };
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  std::vector<Piece> pieces;
};

/// Divides a solid that is no stack, but becomes several when it is cut by planes of its faces: a bracket, a
/// fork, a bent sheet. Each piece is divided as a stack or as a turned solid
/// (see `swept_cells`, `turned_cells`); then what divides one piece
/// where it meets another is carried on into the other.
/// @param cuts     planes by which it is cut first, whatever comes of it
/// @param seconds  of the processor, after which no further planes are tried
/// @return  nothing for a solid of which no such pieces were found
/// @throws Error invalid_argument  a plane that does not cut the solid, by its number
/// @throws Error unsupported  it was cut so, but a piece cannot be divided, or the pieces cannot be made to
/// meet: says where
/// @cost  some 50 ms for each plane that is tried, a second where faces are splines, 100 of them at most, and
/// what the stacks take
std::optional<PiecedCells> pieced_cells(const geometry::Brep& solid,
                                        const std::vector<geometry::PlaneSurface>& cuts = {},
                                        double seconds = 15);

}  // namespace isopatch::segmentation
