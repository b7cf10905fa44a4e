#pragma once

#include <vector>

#include "segmentation/parameterization/deviation_grid.hpp"
#include "segmentation/parameterization/internal/hex_complex.hpp"

namespace isopatch::segmentation {

/// Patches made by the five steps of the paper, and how far their faces are from the surfaces.
struct PaperPatches {
  std::vector<geometry::NurbsVolume> patches;  ///< cubic, three inner knots a direction: 343 control points
  std::vector<DeviationGrid> face_deviations;  ///< by face of the complex
};

/// 1. each edge of each face sampled at 10 points of equal arc length; 2. their blend in the face's domain,
/// on the surface; 3. the blend of the six faces' points inside; 4. a least squares fit of all 1000
/// points; 5. control points that two blocks should share replaced by their mean.
///
/// Neither edges nor folds get any further care: that is what it is compared for.
/// @source Pauley, Nguyen, Mayer, Speh, Weeger, Juettler, The isogeometric segmentation pipeline, section 4
PaperPatches paper_patches(const HexComplex& complex);

}  // namespace isopatch::segmentation
