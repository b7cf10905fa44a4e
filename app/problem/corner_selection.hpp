#pragma once

#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/problem/corners.hpp"

namespace isopatch::app {

/// The corners of patches at a place, to 1e-4 of the model's size: the first patch that has one there, in
/// every body that has.
///
/// @param model   in m
/// @param wanted  m
std::vector<iga::PatchCorner> corners_at(const geometry::MultiPatch& model, const Eigen::Vector3d& wanted);

}  // namespace isopatch::app
