#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/study/config_value.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// How the sides of patches are called: those of the input become those of the model.
using SideNaming = std::function<geometry::PatchFace(const geometry::PatchFace&)>;

/// The faces that a study names: those of a boundary, or the side of a patch as "0:back".
///
/// Names are looked up among all kinds: a boundary "bore" is also "face:bore", a colour "#ff0000", in
/// capitals or not, also "colour:#ff0000", a side "0:back" also "side:0:back". A name with two meanings is
/// refused.
///
/// @param boundaries  in the naming wanted of the result
/// @param from_input     brings sides as the input calls them into that naming; none: as they are written
/// @throws Error invalid_argument, beginning with the place, for what does not exist, naming what comes near,
///     and for two meanings, with the forms that tell them apart
std::vector<geometry::PatchFace> faces_named(const std::string& text, int patch_count,
                                             const std::vector<geometry::Boundary>& boundaries,
                                             const Place& place, const SideNaming& from_input = {});

/// The side of a patch as the input calls it: "0:back".
/// @throws Error invalid_argument  for what is no side
geometry::PatchFace side_named(const std::string& text, int patch_count);

/// "boundaries: inner, outer", for messages.
std::string listed_boundaries(const std::vector<geometry::Boundary>& boundaries);

}  // namespace isopatch::app
