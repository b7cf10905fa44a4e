#pragma once

#include "segmentation/parameterization/internal/domain_mesh.hpp"

namespace isopatch::segmentation {

/// A mesh whose triangles are small and wide enough to solve on, from one that only follows its surface.
///
/// Edges that are long in space are halved, longest first, and edges flipped while that widens the smallest
/// angle in the domain; the outline is halved along its curves. No edge inside joins two points of one side.
/// @param outline_pieces  at least that many on each side
/// @param triangles       about how many there will be at least
/// @cost  O(triangles log triangles) a round of halving or flipping, some ten rounds
DomainMesh refined(DomainMesh mesh, const std::array<DomainCurve, 4>& sides, const DomainSurface& surface,
                   int outline_pieces, int triangles);

}  // namespace isopatch::segmentation
