#pragma once

#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/problem/corners.hpp"

namespace isopatch::app {

/// The corners of patches at a place, to 1e-4 of the model's size, in every body that has one there: that of
/// the first patch, with which patches that match share it, and those of patches whose faces do not match.
///
/// @param model   in m
/// @param wanted  m
std::vector<iga::PatchCorner> corners_at(const geometry::MultiPatch& model, const Eigen::Vector3d& wanted);

}  // namespace isopatch::app
