#pragma once

#include <vector>

#include "segmentation/profiles/profile.hpp"
#include "segmentation/turned/internal/core_strips.hpp"
#include "segmentation/turned/turned_request.hpp"

namespace isopatch::segmentation {

/// Draws rays into a half profile, one after the other; curves that they begin on or meet are divided there.
/// @throws Error unsupported  a ray that begins on no curve, or meets none
void draw_rays(const geometry::Brep& solid, const TurnedFrame& frame,
               const std::vector<TurnedRequest::Ray>& rays, CoredProfile& half);

/// What the curves of a half profile bound, which has no holes.
/// @throws Error unsupported  it has
std::vector<ProfileRegion> half_regions(const geometry::Brep& solid, const TurnedFrame& frame,
                                        const HalfProfile& half);

}  // namespace isopatch::segmentation
