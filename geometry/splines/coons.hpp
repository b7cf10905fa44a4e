#pragma once

#include <array>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// The surface between four curves over [0, 1] that is the sum of the two straight blends of opposite ones
/// less that of the corners, in homogeneous coordinates: exact on all four.
/// @param sides  each starts where the one before ends, with weights 1 there: v = 0, u = 1, v = 1, u = 0.
///               The surface's normal looks to where they run counterclockwise
/// @throws Error invalid_argument  another range of parameters, sides that do not meet
/// @source Coons, Surfaces for computer-aided design of space forms, 1967
NurbsSurface coons_surface(const std::array<NurbsCurve, 4>& sides);

}  // namespace isopatch::geometry
