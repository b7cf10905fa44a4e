#pragma once

#include <optional>
#include <vector>

#include "geometry/base/angle.hpp"
#include "geometry/base/ids.hpp"
#include "geometry/topology/edge_graph.hpp"

namespace isopatch::segmentation {

/// By the dihedral angle inside the cell: below, at or above 180 degrees.
enum class EdgeKind { convex, flat, non_convex };
const char* name(EdgeKind kind);

/// The graph of one cell that is to be cut: its corners, edges and sides without their geometry. Pure data.
///
/// Edge e of a face joins corners e and e + 1 of it. Between two vertices there is at most one edge, so a
/// face's corners say which its edges are. Nothing is promised; `CellIncidence` checks when it is made.
struct CellGraph {
  struct Edge {
    VertexId start, end;
    EdgeKind kind = EdgeKind::convex;
    std::optional<Angle> angle;  ///< the dihedral angle inside the cell where known, (0, 360) degrees
    bool operator==(const Edge&) const = default;
  };
  /// Counter-clockwise, seen from outside the cell.
  using Corners = std::vector<VertexId>;

  int vertex_count = 0;
  std::vector<Edge> edges;
  std::vector<Corners> faces;

  const Edge& edge(EdgeId id) const { return edges[static_cast<std::size_t>(id.value)]; }
  const Corners& face(FaceId id) const { return faces[static_cast<std::size_t>(id.value)]; }
  bool operator==(const CellGraph&) const = default;
};

/// All of whose edges are convex. Edges are numbered as the faces meet them and run as they are met first.
/// @throws Error invalid_argument  a vertex out of range, a face of fewer than three corners
CellGraph cell_graph(int vertex_count, const std::vector<std::vector<int>>& faces);

/// With the same numbers of vertices, edges and faces; all edges convex.
/// @throws Error unsupported  a face with inner loops, two edges between the same vertices, a closed edge
CellGraph cell_graph(const geometry::EdgeGraph& graph);

/// With the same numbers of vertices, edges and faces.
/// @throws Error invalid_argument  a side of a face that is no edge
geometry::EdgeGraph edge_graph(const CellGraph& graph);

/// The edge between two vertices.
std::optional<EdgeId> edge_between(const CellGraph& graph, VertexId a, VertexId b);

/// How many edges are not convex (flat ones are not counted).
int non_convex_count(const CellGraph& graph);

}  // namespace isopatch::segmentation
