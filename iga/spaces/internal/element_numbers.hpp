#pragma once

#include <array>
#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::iga {

/// A number for each element along each direction of a patch.
using ElementNumbers = std::array<std::vector<double>, 3>;

/// Makes the numbers along the two sides of every interface equal, to the larger one of each element, and so
/// on from patch to patch.
/// @throws Error not_conforming  an interface whose sides have different numbers of elements
void share_along_interfaces(const geometry::MultiPatch& model, std::vector<ElementNumbers>& all);

}  // namespace isopatch::iga
