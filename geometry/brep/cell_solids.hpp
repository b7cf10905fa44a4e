#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::geometry {

/// A solid as a complex of one cell: faces, edges and vertices keep their numbers, each face is a side.
/// @throws Error unsupported  a face with inner loops or a seam, a closed edge: names it
CellComplex one_cell(const Brep& source);

/// Cells as solids, in one frame: faces, edges and vertices that cells share are the same ones in all.
///
/// Face i of a solid is the i-th of its cell; names and colours are those of the source, where faces without
/// a name are called "face 3" by their number. Vertices are in the order of their numbers in the complex.
/// @param source  what the complex was made of
/// @throws Error not_manifold  a cell that is not closed
std::vector<Brep> cell_solids(const Brep& source, const CellComplex& complex,
                              const std::vector<CellId>& cells);
/// All cells.
std::vector<Brep> cell_solids(const Brep& source, const CellComplex& complex);

}  // namespace isopatch::geometry
