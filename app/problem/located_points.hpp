#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/study/config_value.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/problem/patch_point.hpp"

namespace isopatch::app {

/// Places of the part as points of its patches, to 1e-4 of the model's size, each with the same weight; the
/// weights add up to 1.
/// @param places  m
/// @param place   of these in the study file
/// @throws Error invalid_argument  a place outside the part, saying by how much
std::vector<iga::PatchPoint> located_points(const geometry::MultiPatch& model,
                                            const std::vector<Eigen::Vector3d>& places, const Place& place);

/// Straight lines from each place to the next as points of patches whose weights are their shares of the
/// length: Gauss points, four in each hundredth of it.
/// @throws Error invalid_argument  as `located_points`, and lines without length
std::vector<iga::PatchPoint> located_line(const geometry::MultiPatch& model,
                                          const std::vector<Eigen::Vector3d>& places, const Place& place);

/// Of the lines from each place to the next, m.
double length_of(const std::vector<Eigen::Vector3d>& places);

}  // namespace isopatch::app
