#pragma once

#include <array>
#include <type_traits>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// The same spline with its directions in another order: direction d of the result is direction `from[d]` of
/// `spline`. An odd permutation turns a right-handed volume into a left-handed one.
/// @throws Error invalid_argument if `from` is not a permutation of 0 .. D - 1
template <int D>
Nurbs<D> permuted(const Nurbs<D>& spline, const std::type_identity_t<std::array<int, D>>& from);

}  // namespace isopatch::geometry
