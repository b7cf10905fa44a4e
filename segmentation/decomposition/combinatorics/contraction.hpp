#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/origin.hpp"

namespace isopatch::segmentation {

/// Without some edges: the faces on both sides of each become one side, and vertices that are left with two
/// edges go, their edges becoming one (the least convex kind of its stretches; no angle unless they agree).
///
/// Vertices of degree two go wherever they are, so without edges to remove it takes out those of T-joints.
/// @return nothing if a side would not be a disc, or two vertices were joined by two edges
/// @throws Error not_manifold  a graph that bounds no ball;  invalid_argument  an edge that it does not have
std::optional<DerivedGraph> contracted(const CellGraph& graph, const std::vector<EdgeId>& edges);

/// The graph of a cell's sides: its flat edges contracted, as far as the result is 3-connected.
///
/// All flat edges together where that is possible, else one after the other in the order of their numbers; a
/// graph that is not 3-connected before and after comes back as it is.
/// @throws Error not_manifold  a graph that bounds no ball
/// @cost  O(flat edges times size of the graph)
DerivedGraph sides(const CellGraph& graph);

}  // namespace isopatch::segmentation
