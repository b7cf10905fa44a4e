#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/origin.hpp"

namespace isopatch::segmentation {

/// The graph with a new vertex, of degree two, inside an edge. It becomes the last vertex, its second half
/// the last edge; both halves have the edge's kind and angle, all other numbers stay.
/// @throws Error invalid_argument  no such edge
DerivedGraph with_vertex_on_edge(const CellGraph& graph, EdgeId edge);

/// The graph with an auxiliary edge across a face. The part of the face to its left, walking from `from` to
/// `to`, keeps the number, the other part is the last face, the new edge the last edge; it is flat, at 180
/// degrees.
/// @throws Error invalid_argument  vertices that are not two corners of the face, or that an edge joins
/// already
DerivedGraph with_edge_across_face(const CellGraph& graph, FaceId face, VertexId from, VertexId to);

/// The graph with all auxiliary vertices and edges of a loop, and the loop's vertices in it.
struct RefinedAlongLoop {
  DerivedGraph derived;
  std::vector<VertexId> loop;
};
/// @return nothing if a step crosses a face between places that are not two corners of one part of it
/// @throws Error invalid_argument  a place that does not exist
std::optional<RefinedAlongLoop> refined_along(const CellGraph& graph, const CuttingLoop& loop);

}  // namespace isopatch::segmentation
