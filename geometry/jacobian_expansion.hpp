#pragma once

#include "geometry/splines/bernstein.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// det J of a Bezier volume over the unit cube, as numerator / weight^4.
///
/// For equal weights the numerator is det J itself. Otherwise, with H = (wX, wY, wZ, w), it is
/// -det[H, H_u, H_v, H_w]: the columns are multiples of (X, 1) but for w (X_u, 0) and so on.
struct JacobianExpansion {
  BernsteinPolynomial numerator;
  double error = 0;  ///< bound of every coefficient's round-off
  double lowest_weight = 1;
  double highest_weight = 1;
};

/// @param piece  one polynomial piece; its size should be about 1, since `error` reckons with control points
/// and
///               weights of that size that are right to a few units in the last place
/// @cost         O(size^2) for size control points
/// @source       Johnen, Remacle, Geuzaine 2013, section 3, for B-splines
JacobianExpansion expand_jacobian(const NurbsVolume& piece);

}  // namespace isopatch::geometry
