#pragma once

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// An L-bracket: [0, leg]^2 without (width, leg]^2, times [0, thickness]. Lengths in model units.
struct BracketOptions {
  double leg = 2;        ///< outer length of both legs
  double width = 1;      ///< of both legs; below leg
  double thickness = 1;  ///< z runs from 0 to thickness
  bool operator==(const BracketOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const BracketOptions& options);

/// Three bricks of degree 1: the corner, the leg along x, the leg along y.
/// Boundaries: x_min, y_min, x_max and y_max (the legs' ends), inner (the two faces at the re-entrant edge),
/// bottom, top.
PatchSet bracket_model(const BracketOptions& options = {});

}  // namespace isopatch::geometry
