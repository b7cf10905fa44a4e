#pragma once

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A quarter of a plate between two ellipses about the z axis, x, y >= 0. The defaults are the plate of
/// NAFEMS LE10. Lengths in model units.
/// @source NAFEMS, The Standard NAFEMS Benchmarks, 1990: LE1 and LE10
struct EllipticPlateOptions {
  double inner_x = 2;      ///< semi-axis of the inner ellipse along x, positive
  double inner_y = 1;      ///< semi-axis of the inner ellipse along y, positive
  double outer_x = 3.25;   ///< above inner_x
  double outer_y = 2.75;   ///< above inner_y
  double thickness = 0.6;  ///< z runs from 0 to thickness
  int layers = 1;          ///< patches through the thickness, 1 .. 1000
  bool operator==(const EllipticPlateOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const EllipticPlateOptions& options);

/// One exact rational patch of degrees (1, 2, 1) a layer, along the way from the inner to the outer ellipse,
/// around and up. Boundaries: inner, outer, x_min and y_min (the symmetry planes), bottom, top.
PatchSet elliptic_plate_model(const EllipticPlateOptions& options = {});

}  // namespace isopatch::geometry
