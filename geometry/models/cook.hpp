#pragma once

#include <array>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Cook's membrane, a tapered and swept cantilever: corners (0, 0), (width, rise), (width, rise +
/// right_height) and (0, left_height). The defaults are the classic dimensions. Lengths in model units.
/// @source Cook, Improved two-dimensional finite element, J. Struct. Div. 1974
struct CookOptions {
  double width = 48;                    ///< positive
  double left_height = 44;              ///< positive
  double right_height = 16;             ///< positive
  double rise = 44;                     ///< y of the lower right corner, any finite number
  double thickness = 1;                 ///< z runs from 0 to thickness
  std::array<int, 2> patches = {1, 1};  ///< along x and along y, 1 .. 1000 each
  bool operator==(const CookOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const CookOptions& options);

/// Patches of degree 1, x running fastest.
/// Boundaries: x_min (the clamped edge), x_max (the loaded edge), y_min, y_max, bottom, top.
PatchSet cook_model(const CookOptions& options = {});

}  // namespace isopatch::geometry
