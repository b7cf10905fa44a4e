#pragma once

#include <vector>

#include "app/study/face_selection.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/problem/region.hpp"

namespace isopatch::app {

/// The region that `part` of a selection says; everywhere without.
/// @throws Error invalid_argument  a box without volume, with the selection's place
iga::Region part_of(const FaceSelection& selection);

/// Those of some faces that have an area in a region.
/// @param place  of the region in the study file
/// @throws Error invalid_argument  none has: names the one that comes nearest
std::vector<geometry::PatchFace> faces_reaching_into(const iga::Region& region,
                                                     const geometry::MultiPatch& model,
                                                     const std::vector<geometry::PatchFace>& faces,
                                                     const Place& place);

/// Refuses a region that reaches beneath patches that cover faces in part.
/// @param faces  that have an area in the region
/// @param place  of the region in the study file
/// @throws Error invalid_argument  naming a face and what covers it there
/// @cost  for each covered face that of the common refinements with those that cover it
void refuse_covered_part(const iga::Region& region, const geometry::MultiPatch& model,
                         const std::vector<geometry::PatchFace>& faces, const Place& place);

}  // namespace isopatch::app
