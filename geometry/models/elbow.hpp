#pragma once

#include "geometry/base/angle.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A pipe elbow: a straight pipe up the z axis from z = 0, a bend towards +x, a straight pipe. Lengths in
/// model units.
struct ElbowOptions {
  double inner_radius = 8;                ///< positive
  double outer_radius = 10;               ///< above inner_radius
  double bend_radius = 20;                ///< of the pipe's axis in the bend; above outer_radius
  Angle bend_angle = Angle::degrees(90);  ///< above 0, at most 180 degrees
  double inlet_length = 15;               ///< straight pipe before the bend, 0 or more
  double outlet_length = 15;              ///< straight pipe behind the bend, 0 or more
  bool operator==(const ElbowOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const ElbowOptions& options);

/// Exact rational patches of degrees (1, 2, 1) in the straight pipes and (1, 2, 2) in the bend along radius,
/// circumference and axis: four around, the bend in pieces of at most 90 degrees.
/// Boundaries: inlet (in the plane z = 0), outlet, inner, outer.
PatchSet elbow_model(const ElbowOptions& options = {});

}  // namespace isopatch::geometry
