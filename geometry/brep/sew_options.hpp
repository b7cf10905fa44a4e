#pragma once

namespace isopatch::geometry {

/// Which gaps between faces are closed.
struct SewOptions {
  /// Points closer than this share of the solid's size are one. Range (0, 0.01).
  double same_point = 1e-4;
  /// Curves between the same two points are one edge if they agree to this share of the solid's size. Range
  /// (0, 0.02).
  double same_curve = 5e-3;
  /// Keeps free edges instead of failing.
  bool accept_open = false;
};

/// @throws Error invalid_argument  naming field, value and range
void validate(const SewOptions& options);

}  // namespace isopatch::geometry
