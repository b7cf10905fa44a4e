#pragma once

#include <vector>

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"

namespace isopatch::segmentation {

/// Which loops are wanted.
struct LoopOptions {
  int max_length = 7;                ///< range 3 .. 1000
  int max_loops = 100000;            ///< after which the search ends; range 1 ..
  std::vector<EdgeId> may_be_split;  ///< edges that may get an auxiliary vertex
};
/// @throws Error invalid_argument  naming field, value and range
void validate(const LoopOptions& options);

struct LoopList {
  std::vector<CuttingLoop> loops;
  bool complete = true;  ///< false if there are more than `max_loops`
};

/// All valid loops of a 3-connected cell without extensions, each once (neither direction nor first place
/// count).
/// @cost exponential in the length at worst; 728 loops of a cell of 30 vertices take about a millisecond
LoopList valid_loops(const CellGraph& graph, const LoopOptions& options = {});

/// Those that pass an edge: its start first, its end second.
/// @param through  not to be split itself
LoopList valid_loops_through(const CellGraph& graph, EdgeId through, const LoopOptions& options = {});

/// Edges that every loop through `edge` has to cross: those between a vertex of the face to its left and one
/// of the face to its right, the edge's own ends apart. If a cell has no valid loop through an edge it has
/// one with an auxiliary vertex on each of these.
/// @source Nguyen, Pauley, Juettler, Graphical Models 76 (2014), Theorem 2
std::vector<EdgeId> impeding_edges(const CellGraph& graph, EdgeId edge);

/// Loops that extend a face along its non-convex edges: for every longest chain of such edges of the face,
/// all loops that run along the chain and extend the face all along it, if both pieces are 3-connected.
LoopList extending_loops(const CellGraph& graph, FaceId face, const LoopOptions& options = {});

}  // namespace isopatch::segmentation
