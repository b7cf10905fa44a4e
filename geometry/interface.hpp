#pragma once

#include <array>
#include <compare>
#include <optional>

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

/// One orientation after the other: parameters go through `first`, then through `second`.
FaceOrientation composed(const FaceOrientation& first, const FaceOrientation& second);

/// An interface as the source of two patches states it, before anybody has looked at their geometry.
struct StatedInterface {
  PatchFace first;
  PatchFace second;
  FaceOrientation orientation;  ///< from first to second
  bool operator==(const StatedInterface&) const = default;
};

/// The same interface seen from the other side.
StatedInterface exchanged(const StatedInterface& interface);

/// What the interface becomes where direction 1 of the first, or of the second, patch is turned around.
StatedInterface turned_around(StatedInterface interface, bool first, bool second);

/// The orientation in which the corners of one face are those of the other; none if they are not.
/// @param first, second  any numbers by which corners are told apart, at (s, t) = (0, 0), (1, 0), (0, 1), (1,
/// 1)
std::optional<FaceOrientation> orientation_between(const std::array<int, 4>& first,
                                                   const std::array<int, 4>& second);

/// Two faces that are the same surface, with the same parameters up to `orientation`.
struct Interface {
  PatchFace first;
  PatchFace second;
  FaceOrientation orientation;  ///< from first to second
  double gap = 0;               ///< largest distance found between the two, model units
  bool operator==(const Interface&) const = default;
};

}  // namespace isopatch::geometry
