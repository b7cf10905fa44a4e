#pragma once

#include <optional>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// A segment or an arc of a circle moved sideways in its plane: with as many control points, and the same
/// weights.
/// @param normal  of the plane, unit
/// @param by      to the left as seen from where the normal points, m
/// @return  nothing for other curves, and for circles that would vanish
std::optional<geometry::NurbsCurve> offset_curve(const geometry::NurbsCurve& curve,
                                                 const Eigen::Vector3d& normal, double by);

}  // namespace isopatch::segmentation
