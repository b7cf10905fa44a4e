#pragma once

#include <vector>

#include <optional>

#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// The cells of a piece of a solid; all its curves are new ones.
struct ComplexOfPiece {
  geometry::CellComplex complex;
  /// By face of the piece: that of the whole solid; nothing where a plane has cut.
  std::vector<std::optional<FaceId>> origin;
};

/// How sides where a plane has cut meet those of other pieces.
enum class CutSides { whole, in_parts };

/// One complex of those of all pieces: what lies in the same place is stored once.
/// @param tolerance  m
/// @throws Error unsupported  a side where a plane has cut has to meet one of another piece as a whole, and
/// does not: says where
geometry::CellComplex joined_complex(const std::vector<ComplexOfPiece>& pieces, double tolerance,
                                     CutSides sides = CutSides::whole);

}  // namespace isopatch::segmentation
