#pragma once

#include <string>
#include <vector>

#include "app/base/warning.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// Warnings about bodies that nearly touch or run into each other, and about patches of one body that run
/// through each other. Each names the two, the distance or the depth, and the place.
///
/// Bodies count as near within a twentieth of the smaller one's size. What is looked at are points of a grid
/// on faces and inside of patches, so that overlaps narrower than a quarter of a patch may stay unseen.
///
/// @param names  of the patches, for messages; empty: their numbers
/// @cost  some ten searches for closest points in each pair of patches whose boxes meet
std::vector<Warning> loose_body_warnings(const geometry::MultiPatch& model,
                                         const std::vector<std::string>& names = {});

}  // namespace isopatch::app
