#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// Puts flat edges across plane sides of the one cell of a complex whose graph is not 3-connected, until it
/// is: what two sides share becomes a vertex or an edge. Cuts then run through them, as through concave
/// edges.
/// @return  nothing where no such edges were found
/// @cost  for each edge, all pairs of corners of sides that meet in more than that
std::optional<geometry::CellComplex> with_artificial_edges(const geometry::Brep& source,
                                                           const geometry::CellComplex& complex);

}  // namespace isopatch::segmentation
