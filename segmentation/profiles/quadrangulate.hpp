#pragma once

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"

namespace isopatch::segmentation {

/// Divides the wanted regions of a profile into few quadrilaterals with corners near right angles, which meet
/// side to side, across shared edges of regions as well. Same input, same result.
/// @throws Error bad_format for an invalid profile, unsupported naming the region where loops cross or no
/// division is found
/// @cost about 1 s for 100 vertices; several times that where no division within the bounds is found
Quadrangulation quadrangulate(const Profile& profile, const QuadrangulationOptions& options = {});

}  // namespace isopatch::segmentation
