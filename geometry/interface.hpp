#pragma once

#include <compare>

#include "geometry/patch_face.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// How the parameters (s, t) in [0, 1]^2 of one face lie on another: exchanged if `swapped`, then each turned
/// around (s becomes 1 - s) if its flag is set. All eight orientations of a square.
struct FaceOrientation {
  bool swapped = false;
  bool flip_first = false;   ///< turns the other face's first parameter around
  bool flip_second = false;  ///< turns the other face's second parameter around

  auto operator<=>(const FaceOrientation&) const = default;

  /// Parameters on the other face, both faces scaled to [0, 1]^2.
  Parameter<2> operator()(const Parameter<2>& parameter) const;
};

FaceOrientation inverse(const FaceOrientation& orientation);

/// Two faces that are the same surface, with the same parameters up to `orientation`.
struct Interface {
  PatchFace first;
  PatchFace second;
  FaceOrientation orientation;  ///< from first to second
  double gap = 0;               ///< largest distance found between the two, model units
};

}  // namespace isopatch::geometry
