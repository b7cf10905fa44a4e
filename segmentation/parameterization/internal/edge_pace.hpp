#pragma once

#include <vector>

#include "segmentation/parameterization/internal/hex_complex.hpp"

namespace isopatch::segmentation {

/// Decides how the edges of a complex are run through, and makes its face maps anew where that is not by arc
/// length.
///
/// An edge keeps the pace of the input where that makes patches exact: along a side of a spline face whose
/// outline is a rectangle of its domain, the pace of the domain; along a spline curve between planes, the
/// curve's own; along an arc, that of its rational form (`EdgeShape::exact`). Only if all blocks around the
/// edge agree with it in space, and if it nowhere slows down so much that patches would be poor. The knots
/// that belong to it are noted in `EdgeShape::knots`.
void choose_paces(HexComplex& complex);

/// Whether any edge of a complex is run through at another pace than that of arc length.
bool has_paces(const HexComplex& complex);
/// The same complex with the input's splines kept along the edges of some sheets, and with its arcs.
/// @param sheets  for each whether they are
HexComplex with_splines_of(const HexComplex& complex, const std::vector<bool>& sheets);
/// The same complex with all edges run through by arc length, and no knots to keep.
HexComplex without_paces(HexComplex complex);

}  // namespace isopatch::segmentation
