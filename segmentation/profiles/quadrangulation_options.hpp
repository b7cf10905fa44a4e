#pragma once

#include "geometry/base/angle.hpp"

namespace isopatch::segmentation {

/// What counts as a good division, and how long is looked for one. The best has the least
///     quadrilaterals + angle_weight * (sum over all corners of (deviation from 90 degrees / 90 degrees)^2)
///                    + length_weight * (sum over all quadrilaterals of how uneven opposite sides are)
struct QuadrangulationOptions {
  Angle smallest_angle = Angle::degrees(15);  ///< of a corner; range 1 to 60 degrees
  Angle largest_angle = Angle::degrees(160);  ///< of a corner; range 120 to 175 degrees
  double smallest_jacobian = 0.12;            ///< scaled, of the transfinite map; range 0 to 0.5
  double angle_weight = 0.6;    ///< 0 or above; an angle of 45 or 135 degrees costs a quarter of this
  double length_weight = 0.05;  ///< 0 or above; of the squared logarithm of opposite sides' ratio of lengths
  int effort = 400;   ///< parts of a division that are divided anew for each 10 vertices; 0 or above
  unsigned seed = 1;  ///< of the order in which they are
  bool operator==(const QuadrangulationOptions&) const = default;
};
/// @throws Error invalid_argument with field, value and range
void validate(const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation
