#pragma once

#include <vector>

#include "app/study/face_selection.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/problem/corners.hpp"

namespace isopatch::app {

/// The corners of patches at some places, to 1e-4 of the model's size: of each place the first patch that has
/// one there, in every body that has.
///
/// @param model   in m
/// @param places  m
/// @param place   of the places in the study file
/// @throws Error invalid_argument  a place without a corner: names the nearest one
std::vector<iga::PatchCorner> select_corners(const geometry::MultiPatch& model,
                                             const std::vector<Eigen::Vector3d>& places, const Place& place);

}  // namespace isopatch::app
