#pragma once

#include <vector>

#include "segmentation/parameterization/internal/hex_complex.hpp"

namespace isopatch::segmentation {

/// Knots on [0, 1] that a fit starts with, by sheet.
///
/// `spans` equal spans; more where an edge winds around more than once, so that samples cannot miss a turn;
/// and the knots of the input's own splines as far as the degree can hold them (`EdgeShape::knots`), if
/// that makes no more than 256.
std::vector<geometry::KnotVector> start_knots(const HexComplex& complex, int degree, int spans);

}  // namespace isopatch::segmentation
