#pragma once

#include "geometry/base/angle.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A sector of a thick-walled cylinder about the z axis, starting in the x-z plane. Lengths in model units.
struct CylinderOptions {
  double inner_radius = 1;           ///< positive
  double outer_radius = 2;           ///< above inner_radius
  double height = 0.5;               ///< positive; z runs from 0 to height
  Angle angle = Angle::degrees(90);  ///< above 0, at most 360 degrees, which gives a closed ring
  int radial_patches = 1;            ///< 1 .. 1000
  int axial_patches = 1;             ///< 1 .. 1000
  int patches_around = 0;  ///< at least so many that each takes 120 degrees or less; 0: 90 degrees or less
  bool operator==(const CylinderOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const CylinderOptions& options);

/// Exact rational patches of degrees (1, 2, 1) along radius, circumference and axis.
/// Boundaries: inner, outer, start, end (neither for a closed ring), bottom, top.
PatchSet cylinder_model(const CylinderOptions& options = {});

}  // namespace isopatch::geometry
