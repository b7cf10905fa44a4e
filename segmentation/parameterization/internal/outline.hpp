#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "segmentation/parameterization/internal/domain_curve.hpp"

namespace isopatch::segmentation {

/// A point of the transfinite bilinear blend of four domain curves, in the order of `QuadFace::sides`.
/// @source Coons 1967
Eigen::Vector2d coons_point(const std::array<DomainCurve, 4>& sides, double s, double t);

/// Where a closed outline crosses itself, if it does; looked for among chords, 24 a curve.
/// @cost O(chords^2)
std::optional<Eigen::Vector2d> self_intersection(const std::vector<DomainCurve>& loop);

/// Twice the signed area of a triangle.
double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace isopatch::segmentation
