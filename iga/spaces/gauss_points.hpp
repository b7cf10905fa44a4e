#pragma once

#include <array>

#include "geometry/quadrature.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::iga {

/// Gauss points per element along the three directions of a patch.
using GaussPoints = std::array<int, 3>;

/// As many points as the map of a patch needs: degree + 1 where it is affine, more where it is rational or so
/// curved that what is integrated is no polynomial which these integrate.
///
/// The integrands of elasticity are products of functions of known degree with cofactors of the map, or with
/// cofactors squared over det J. Both are sampled on some lines through some elements, and their Legendre
/// coefficients say of what degree they are: cofactors to 1e-10, so that a constant stress is in equilibrium
/// with its traction to about 1e-9, and the others to the share of a percent that energies can bear.
/// At most 8 points more than degree + 1, and none more where the map is folded or collapsed.
///
/// @param patch  in the solution space
/// @cost  at most 216 lines of 16 points: a millisecond, whatever the number of elements; nothing for affine
/// maps
GaussPoints gauss_points(const geometry::NurbsVolume& patch);

/// The rules with so many points.
std::array<geometry::QuadratureRule, 3> gauss_rules(const GaussPoints& points);

}  // namespace isopatch::iga
