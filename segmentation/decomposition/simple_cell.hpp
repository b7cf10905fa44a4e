#pragma once

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation {

/// Whether three edges meet at every vertex: such a cell is as many hexahedra as it has vertices, if it is
/// convex.
bool is_simple(const CellGraph& graph);

/// How many hexahedra a cell becomes, about: 1 for a hexahedron, as many as the vertices of another simple
/// one, more where it must be cut at vertices before.
double hexahedra_of(const CellGraph& graph);

}  // namespace isopatch::segmentation
