#pragma once

#include "geometry/brep/cell_complex.hpp"

namespace isopatch::geometry {

/// The least scaled Jacobian of hexahedra whose edges are blended (Coons), on 4 x 4 x 4 points of each: what
/// patches may be expected to have before any is fitted. Below zero where a hexahedron would be folded.
/// @param complex  of hexahedra; edges that are no curves of their own, but the source's, are taken straight
/// @cost  some 10 microseconds a hexahedron
double least_quality(const CellComplex& complex);

}  // namespace isopatch::geometry
