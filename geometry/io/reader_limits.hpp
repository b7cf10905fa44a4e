#pragma once

#include <cstdint>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::geometry {

/// Most patches accepted from one file.
inline constexpr int max_patches = 10'000;
/// Most control points accepted for one patch, and most of anything that a file may count.
inline constexpr int max_control_points = 100'000'000;

/// Number of control points for three knot vectors.
/// @throws Error bad_format if it exceeds `max_control_points`
std::int64_t checked_control_points(const KnotVector& u, const KnotVector& v, const KnotVector& w);

}  // namespace isopatch::geometry
