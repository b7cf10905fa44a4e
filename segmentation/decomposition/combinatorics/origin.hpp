#pragma once

#include <vector>

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"

namespace isopatch::segmentation {

/// A stretch of an edge of a derived graph, in terms of the graph it comes from: an edge or a part of one, or
/// an auxiliary edge across a face. Runs from one place to the other in the sense of the derived edge.
struct EdgeStretch {
  LoopPlace from, to;
  EdgeId edge;  ///< -1 for an auxiliary edge
  FaceId face;  ///< the one that an auxiliary edge crosses, else -1
  bool operator==(const EdgeStretch&) const = default;
};

/// A face of a derived graph: the faces of the graph it comes from that it is, or is part of, ascending.
struct FaceOrigin {
  std::vector<FaceId> faces;
  bool is_new = false;  ///< has the new face of a cut in it; without any other it is nothing else
  bool operator==(const FaceOrigin&) const = default;
};

/// A graph made from another one, and where everything in it comes from.
struct DerivedGraph {
  CellGraph graph;
  std::vector<LoopPlace> vertices;  ///< of vertex k: the vertex it is, or the edge that it was put in
  std::vector<std::vector<EdgeStretch>>
      edges;                      ///< of edge k: one stretch, more where vertices of degree two went
  std::vector<FaceOrigin> faces;  ///< of face k
  bool operator==(const DerivedGraph&) const = default;
};

/// The two pieces of a cell, each with origins in it. Of two faces that are one, the new face's origin is in
/// both.
///
/// The angles of the loop's edges are guesses for geometry to correct: an edge is convex in both pieces with
/// half its angle, an auxiliary edge with 90 degrees; where a face is extended the edge is convex in the
/// other piece, with 180 degrees less than it had.
struct CutPieces {
  DerivedGraph left, right;
};

/// The graph itself as derived from itself.
DerivedGraph identity(const CellGraph& graph);

/// Of a graph derived from a derived one: its origins in the first.
/// @param second  derived from first.graph
DerivedGraph composed(const DerivedGraph& first, const DerivedGraph& second);

}  // namespace isopatch::segmentation
