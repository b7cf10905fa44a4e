#pragma once

#include "segmentation/parameterization/internal/hex_complex.hpp"

namespace isopatch::segmentation {

/// Curves, surfaces and maps of the blocks of a model; edges run at the paces of the input's splines where
/// that makes patches exact.
HexComplex model_complex(const HexModel& model);

}  // namespace isopatch::segmentation
