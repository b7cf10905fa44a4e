#pragma once

#include <string>

#include "geometry/brep/read_brep.hpp"

namespace isopatch::segmentation {

/// Refuses faces that are no face of a hexahedron by themselves.
/// @throws Error unsupported  a face that is closed on itself (a whole cylinder), has holes, is bounded by a
/// closed edge, has not four corners or visits a vertex twice: names it, where and what to do
void refuse_faces(const geometry::BrepFile& solid);

/// A face's name, "face 2" where it has none.
std::string face_name(const geometry::Brep& brep, FaceId face);

/// A face in a sentence: "face 3" where that is its name, otherwise "face 'lid'".
std::string face_in_words(const std::string& name);

/// "solid 'shaft', face 'lid'".
std::string described(const geometry::BrepFile& solid, FaceId face);

}  // namespace isopatch::segmentation
