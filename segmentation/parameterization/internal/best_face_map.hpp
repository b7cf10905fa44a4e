#pragma once

#include <array>

#include "segmentation/parameterization/internal/face_map.hpp"

namespace isopatch::segmentation {

/// A map of the unit square to a face: the blend of its sides, or, where that folds, leaves the domain or
/// gets narrow angles, the mean-value map if it is better. Bijective if `smallest_sine` is positive, which no
/// smooth map is for a face with a corner of more than 180 degrees.
///
/// @source Coons 1967; Floater 2003
FaceMap best_face_map(const QuadFace& face);
/// The same with paces along the sides.
FaceMap best_face_map(const QuadFace& face, const std::array<SidePace, 4>& paces);

}  // namespace isopatch::segmentation
