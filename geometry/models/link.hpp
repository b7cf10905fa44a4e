#pragma once

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A link like a connecting rod: two eyes with bores along z, joined by a straight shank with fillets. The
/// left bore's axis is the z axis, the right one's goes through (distance, 0). Lengths in model units.
struct LinkOptions {
  double distance = 100;           ///< between the bores' axes; at least what eyes and fillets need
  double left_bore_radius = 10;    ///< positive
  double right_bore_radius = 7;    ///< positive
  double left_outer_radius = 20;   ///< above left_bore_radius
  double right_outer_radius = 14;  ///< above right_bore_radius
  double shank_width = 16;         ///< along y; below twice the smaller outer radius
  double fillet_radius = 20;       ///< of the four arcs that lead from the eyes to the shank, tangent to both
  double thickness = 12;           ///< z runs from 0 to thickness
  int shank_patches = 1;           ///< patches along the straight part of the shank, 1 .. 1000
  bool operator==(const LinkOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const LinkOptions& options);

/// Exact rational patches of degrees at most (2, 2, 1): four about each bore, one neck at each end of the
/// shank, the shank. Boundaries: bore_left, bore_right, end_left, end_right (the round ends), sides (fillets
/// and shank), bottom, top.
PatchSet link_model(const LinkOptions& options = {});

}  // namespace isopatch::geometry
