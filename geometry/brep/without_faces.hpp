#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"

namespace isopatch::geometry {

/// A solid without some of its faces: their neighbours are extended until they meet. Rounds go if all of a
/// chain are named at once. Other faces keep their order, names and colours.
/// @throws Error unsupported  the neighbours do not meet, or more than the faces would change
Brep without_faces(const Brep& solid, const std::vector<FaceId>& faces);

}  // namespace isopatch::geometry
