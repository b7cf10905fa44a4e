#pragma once

#include <vector>

#include "geometry/interface_search.hpp"
#include "geometry/patch_face.hpp"

namespace isopatch::geometry {

/// Two faces of which a part of each, or all, is the same surface, with other parameters or another outline:
/// a T-joint, or neighbours that were parametrized apart.
struct NonMatchingInterface {
  PatchFace first;
  PatchFace second;
  double gap = 0;  ///< largest distance found between the two where they meet, model units
  bool operator==(const NonMatchingInterface&) const = default;
};

/// Non-matching interfaces, and what they leave of the faces that meet no other face as a whole.
struct NonMatchingFaces {
  std::vector<NonMatchingInterface>
      interfaces;                         ///< ordered by their faces, of which the first is the smaller
  std::vector<PatchFace> boundary;        ///< of the faces given: those not covered all over
  std::vector<PatchFace> partly_covered;  ///< those of `boundary` that others cover in part
};

/// Looks at 24 x 24 points inside each face: where one lies on another face to `same_point`, and the outward
/// normals are opposite, the two faces are an interface there.
/// @param faces       that have an area and meet no other as a whole
/// @param same_point  model units
/// @throws Error not_conforming  faces that lie on one another with their patches on the same side
/// @cost   O(faces log faces), and up to 576 nearest points for both of each two faces with overlapping boxes
NonMatchingFaces find_non_matching(const std::vector<NurbsVolume>& patches,
                                   const std::vector<PatchFace>& faces, double same_point,
                                   const FaceLabel& label);

}  // namespace isopatch::geometry
