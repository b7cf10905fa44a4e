#pragma once

#include "geometry/base/angle.hpp"

namespace isopatch::segmentation {

/// What counts as a good division, and how long is looked for one. The best has the least sum over its
/// quadrilaterals of
///     1 + angle_weight * (sum over corners of d^2 (1 + 3 d^4), d = (angle - 90 degrees) / 90 degrees)
///       + turn_weight * (sum over pairs of opposite sides of what they turn on average beyond a right angle,
///       in right angles)
///       + length_weight * (sum over pairs of opposite sides of ((a - b) / (a + b))^2, a and b their lengths)
///       + aspect_weight * ((p - q) / (p + q))^2, p and q the sums of lengths of opposite sides
///       + slant_weight * (sum over chords of sin^2(4 angle to the longest line))
/// All weights are 0 or above.
struct QuadrangulationOptions {
  Angle smallest_angle = Angle::degrees(15);  ///< of a corner; range 1 to 60 degrees
  Angle largest_angle = Angle::degrees(165);  ///< of a corner; range 120 to 175 degrees
  Angle largest_turn = Angle::degrees(125);   ///< of the tangent along one side; range 60 to 180 degrees
  double smallest_jacobian = 0.12;  ///< of the transfinite map, scaled (see `QuadShape`); range 0 to 0.5
  double angle_weight = 0.16;  ///< an angle of 45 or 135 degrees costs 0.3 of this, one of 30 or 150 0.71
  double turn_weight = 1.1;    ///< a third of a ring costs a third of this, so that rings are quartered
  double length_weight = 0.2;
  double aspect_weight = 0.12;
  double slant_weight = 0.02;  ///< of equal divisions the one along the drawing's directions is taken
  int effort = 400;   ///< parts of a division that are divided anew for each 10 of its cells and 5 more, in
                      ///< each of 4 searches; 0 or above
  unsigned seed = 1;  ///< of the order in which they are
  /// Whether drawings of several regions are also divided from their corners alone, regions left open are
  /// mended together, and rows of quadrilaterals that run through several of them are taken out at the end
  /// where that makes the drawing cheaper. Twice the time, and seconds more for a hundred cells.
  bool thorough = false;
  /// Thorough drawings have quadrilaterals with such a least scaled Jacobian where that costs few more;
  /// better ones are not worth another; range 0.05 to 0.6.
  double good_jacobian = 0.25;
  bool operator==(const QuadrangulationOptions&) const = default;
};
/// @throws Error invalid_argument with field, value and range
void validate(const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation
