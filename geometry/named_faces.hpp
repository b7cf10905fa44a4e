#pragma once

#include <string_view>
#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// The faces of a boundary that the model's source has named.
/// @throws Error invalid_argument  there is none of that name; lists those that there are
std::vector<PatchFace> named_faces(const MultiPatch& model, std::string_view name);

}  // namespace isopatch::geometry
