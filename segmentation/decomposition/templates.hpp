#pragma once

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// Makes hexahedra of the cells of a complex, in all vertices of which three edges of the cell meet, and
/// which meet side to side.
///
/// Hexahedra stay as they are, a prism over n corners becomes n, any other cell as many as it has vertices,
/// by points in the middle of its edges, sides and inside (a tetrahedron four). What has to be divided in
/// neighbours for that is, and no more: an edge is divided if a side without four corners has it, and with it
/// all that lie across a side with four corners from it. So what comes out meets side to side.
/// @throws Error unsupported  a vertex with four edges or more, a cell that meets another one in part of a
/// side
geometry::CellComplex hexahedral(const geometry::Brep& source, geometry::CellComplex complex,
                                 double tolerance);

}  // namespace isopatch::segmentation
