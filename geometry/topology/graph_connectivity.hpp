#pragma once

#include <optional>
#include <vector>

#include "geometry/topology/edge_graph.hpp"

namespace isopatch::geometry {

/// Two faces that meet in more than a vertex or an edge (the same face twice: it touches itself).
struct FaceConflict {
  FaceId first, second;
  VertexId u, v;  ///< that they share without the edge between them; equal where a face touches itself in one
};

/// The connectivity of a graph, and what keeps it from being 3-connected.
struct ConnectivityReport {
  bool connected = false;
  std::vector<EdgeId> loops;  ///< edges that start where they end
  /// Edges between vertices that an earlier edge already joins.
  std::vector<EdgeId> parallel;
  std::vector<VertexId> low_degree;  ///< with fewer than three edges
  /// Of the pairs of faces that conflict, the first. Removing its two vertices takes the graph apart.
  std::optional<FaceConflict> conflict;

  bool simple() const { return loops.empty() && parallel.empty(); }
  /// No two vertices can be removed so that the rest falls apart, and there are at least four.
  bool three_connected = false;
};

/// For a graph that bounds a ball and whose faces are discs it decides 3-connectivity; for others only the
/// first three members are filled in beside `conflict`, and `three_connected` is false.
///
/// Such a graph is 3-connected iff it is simple, has no vertex of degree below three and any two of its faces
/// share nothing, a vertex, or an edge with its ends.
/// @cost  O(sum of the squares of the degrees, times the corners of a face)
/// @source Juettler, Kapl, Nguyen, Pan, Pauley, CAD 57 (2014), Lemma 2, in the form for all pairs of faces
ConnectivityReport connectivity(const EdgeGraph& graph, const TopologyReport& topology);

/// Whether a 3-connected graph is that of a cube: six faces of four corners, eight vertices of three edges.
bool is_cube(const EdgeGraph& graph, const ConnectivityReport& report);

}  // namespace isopatch::geometry
