#pragma once

#include "geometry/brep/brep.hpp"
#include "segmentation/parameterization/hex_solid.hpp"

namespace isopatch::segmentation {

/// What the parameterization needs to know of a boundary representation; lengths are metres.
///
/// Vertices and faces keep their numbers. Faces without a name are called "face 0", "face 1", ...
/// @throws Error unsupported  a face with inner outlines or none, naming it
HexSolid hex_solid(const geometry::Brep& brep, const std::string& name);

}  // namespace isopatch::segmentation
