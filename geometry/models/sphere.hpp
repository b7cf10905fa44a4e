#pragma once

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// The octant x, y, z >= 0 of a hollow sphere about the origin. Lengths in model units.
struct SphereOptions {
  double inner_radius = 1;  ///< positive
  double outer_radius = 2;  ///< above inner_radius
  int radial_patches = 1;   ///< 1 .. 1000
  bool operator==(const SphereOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const SphereOptions& options);

/// Three exact rational patches of degrees (4, 4, 1) for each layer, about the x, the y and the z axis; they
/// meet on the line x = y = z. Radii are traversed at constant speed.
///
/// Seen from the opposite pole, by stereographic projection, a patch is a planar quadrilateral between two
/// lines and two circles; it is filled with a rational biquadratic map, and the projection back doubles its
/// degree. Boundaries: inner, outer, x0, y0, z0 (the planes x = 0, y = 0, z = 0).
/// @source Dietz, Hoschek, Juettler, An algebraic approach to curves and surfaces on the sphere, CAGD 1993
PatchSet sphere_model(const SphereOptions& options = {});

}  // namespace isopatch::geometry
