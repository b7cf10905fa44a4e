#pragma once

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A quarter of a plate with a round hole about the z axis: [0, width] x [0, height] without the hole.
/// Lengths in model units.
struct PlateOptions {
  double width = 4;        ///< half of the whole plate's, along x; above hole_radius
  double height = 4;       ///< half of the whole plate's, along y; above hole_radius
  double hole_radius = 1;  ///< positive
  double thickness = 1;    ///< z runs from 0 to thickness
  bool operator==(const PlateOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const PlateOptions& options);

/// Two exact rational patches of degrees (1, 2, 1) that meet on the line to the plate's corner; they are well
/// shaped while width and height differ by less than a factor of about three. Boundaries: hole, x_min and
/// y_min (the symmetry planes), x_max, y_max, bottom, top.
PatchSet plate_model(const PlateOptions& options = {});

}  // namespace isopatch::geometry
