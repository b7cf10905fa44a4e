#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/brep/brep_parts.hpp"

namespace isopatch::segmentation {

/// The point nearest to a start at which carriers meet: on all of them, and on the line of contact of those
/// that touch. Where they leave it free, as two do along their curve, it moves as little as possible.
/// @param size  of the model, m: what counts as no step any more
Eigen::Vector3d meeting_point(const std::vector<geometry::Carrier>& carriers, const Eigen::Vector3d& start,
                              double size);

}  // namespace isopatch::segmentation
