#pragma once

#include "geometry/base/angle.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A straight beam along x whose rectangular section turns evenly about the axis, right-handed, from the root
/// at x = 0, where its width lies along y and its depth along z. The defaults are the beam of MacNeal and
/// Harder. Lengths in model units.
/// @source MacNeal, Harder, A proposed standard set of problems to test finite element accuracy, Finite
///         Elements in Analysis and Design 1985
struct TwistedBeamOptions {
  double length = 12;                ///< positive
  double width = 1.1;                ///< positive
  double depth = 0.32;               ///< positive
  Angle twist = Angle::degrees(90);  ///< from root to tip; above 0, at most 720 degrees
  bool operator==(const TwistedBeamOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const TwistedBeamOptions& options);

/// One patch of degrees (3, 1, 1) along the axis, the width and the depth. Sections are exact rectangles but
/// for their size and turn, because a helix is no spline: the cosine and the sine of the turn are clamped
/// cubic interpolants, smooth (C^2), with a piece for every 5 degrees or less. Every point is within
/// 1e-6 times its distance from the axis of where it should be; root and tip are exact.
/// Boundaries: root, tip, sides.
PatchSet twisted_beam_model(const TwistedBeamOptions& options = {});

}  // namespace isopatch::geometry
