#pragma once

#include "geometry/brep/brep.hpp"
#include "segmentation/parameterization/hex_solid.hpp"

namespace isopatch::segmentation {

/// What the parameterization needs to know of a boundary representation; lengths are metres.
///
/// Vertices and faces keep their numbers. Faces without a name are called "face 0", "face 1", ...
/// @param edge_uncertainty  as in HexSolid, m: `BrepFile::largest_correction`
/// @throws Error unsupported  a face that is closed on itself (a whole cylinder), has holes, or is bounded by
/// a closed edge: names it, where and what to do
HexSolid hex_solid(const geometry::Brep& brep, const std::string& name, double edge_uncertainty = 0);

}  // namespace isopatch::segmentation
