#pragma once

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"

namespace isopatch::segmentation {

/// A loop that every 3-connected cell has, but for the tetrahedron: it cuts off one vertex, or passes it.
/// The shortest of those at all vertices.
/// @throws Error unsupported  for a tetrahedron;  not_three_connected
CuttingLoop constructive_loop(const CellGraph& graph);

}  // namespace isopatch::segmentation
