#pragma once

#include <string>
#include <vector>

#include "app/study/config_value.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// The faces that a study names: those of a boundary, or one as "0:back".
/// @param boundaries  in the naming wanted of the result; faces "0:back" come out as they are written
/// @throws Error invalid_argument, beginning with the place, for what does not exist, naming what comes near
std::vector<geometry::PatchFace> faces_named(const std::string& text, int patch_count,
                                             const std::vector<geometry::Boundary>& boundaries,
                                             const Place& place);

/// "boundaries: inner, outer", for messages.
std::string listed_boundaries(const std::vector<geometry::Boundary>& boundaries);

}  // namespace isopatch::app
