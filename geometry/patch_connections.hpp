#pragma once

#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// What `connect` finds out about patches, as plain data: with the patches themselves, or refinements of
/// them, it makes the same model again.
struct PatchConnections {
  std::vector<Interface> interfaces;
  std::vector<Boundary> boundaries;  ///< faces as `MultiPatch::patches()` has them
  std::vector<bool> reversed;        ///< per patch: turned around when it was read
  Tolerance tolerance;
  double size = 1;  ///< `MultiPatch::size()`, that the tolerance is relative to
};

PatchConnections connections_of(const MultiPatch& model);

/// @throws Error invalid_argument  faces that do not exist or are joined twice, a flag too many or too few
void validate(const PatchConnections& connections, std::size_t patch_count);

/// The model that has these connections, with the input's names for faces and parameters.
/// @param patches  as `MultiPatch::patches()` gives them, refined or not
/// @throws Error invalid_argument  as `validate` does, and for patches that do not meet as the connections
/// say
/// @cost   that of `connect`
MultiPatch connected(const std::vector<NurbsVolume>& patches, const PatchConnections& connections);

}  // namespace isopatch::geometry
