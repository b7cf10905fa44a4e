#pragma once

#include <vector>

#include "geometry/brep/cell_complex.hpp"
#include "segmentation/pieces/internal/piece.hpp"

namespace isopatch::segmentation {

/// One complex of those of all pieces: what lies in the same place is stored once.
/// @param complexes  by piece
/// @throws Error unsupported  a side where a plane has cut meets no side of another piece: says where
geometry::CellComplex joined_complex(const std::vector<Piece>& pieces,
                                     const std::vector<geometry::CellComplex>& complexes);

}  // namespace isopatch::segmentation
