#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// Points that a surface is to pass, (3, n), and where in its domain, (2, n).
struct SurfacePoints {
  Eigen::Matrix2Xd uv;
  Eigen::Matrix3Xd points;
};

/// The spline surface that bends least among those through given points; where a space has none through
/// all, nearly one that is nearest to them in the sense of least squares.
/// @param knots  of its space, which contains all `uv`
/// @throws Error invalid_argument  fewer than three points, or all on one line of the domain
/// @cost  one sparse system with as many unknowns as control points and points
NurbsSurface smooth_surface(const SurfacePoints& through, const std::array<KnotVector, 2>& knots);

}  // namespace isopatch::geometry
