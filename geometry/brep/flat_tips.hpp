#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/drill_tip.hpp"

namespace isopatch::geometry {

/// Cones that look at their axis, end in their apex, and begin with a circle around it.
std::vector<DrillTip> drill_tips(const Brep& solid);

/// A solid whose drill tips end in a flat each instead of the apex, where no regular patch could end. The
/// flats come after all other faces, and have the names and colours of their cones.
/// @param share  of the flat's radius in the cone's, in (0, 1)
/// @throws Error unsupported  the CAD library cannot do it
Brep with_flat_tips(const Brep& solid, const std::vector<DrillTip>& tips, double share);

}  // namespace isopatch::geometry
