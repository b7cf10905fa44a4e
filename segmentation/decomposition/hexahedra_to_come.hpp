#pragma once

#include <vector>

#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// How many hexahedra `hexahedral` makes of cells that meet side to side, and a guess from below where some
/// do not yet. Edges that a template divides are divided in all cells across sides of four corners.
/// @param cells  the sides of every cell
/// @cost  O(edges)
double hexahedra_to_come(const geometry::CellComplex& complex, const std::vector<CellSides>& cells);

}  // namespace isopatch::segmentation
