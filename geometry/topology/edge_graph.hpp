#pragma once

#include <vector>

#include "geometry/base/ids.hpp"
#include "geometry/topology/edge_use.hpp"

namespace isopatch::geometry {

/// The boundary of a solid without its geometry: vertices, edges and the loops of faces. Pure data.
///
/// Nothing is promised: the functions below and in `graph_connectivity.hpp` say what is true of it.
struct EdgeGraph {
  struct Edge {
    VertexId start, end;
  };
  struct Face {
    std::vector<std::vector<EdgeUse>> loops;  ///< the face to the left, seen from outside; outer loop first
  };
  /// A place in a loop.
  struct Place {
    FaceId face;
    int loop = 0;
    int position = 0;
    bool reversed = false;  ///< how the edge is walked there
  };

  int vertex_count = 0;
  std::vector<Edge> edges;
  std::vector<Face> faces;

  const Edge& edge(EdgeId id) const { return edges[static_cast<std::size_t>(id.value)]; }
  const Face& face(FaceId id) const { return faces[static_cast<std::size_t>(id.value)]; }
  VertexId from(EdgeUse use) const { return use.reversed ? edge(use.edge).end : edge(use.edge).start; }
  VertexId to(EdgeUse use) const { return use.reversed ? edge(use.edge).start : edge(use.edge).end; }
};

/// Of a map given by the vertices around each face, counter-clockwise seen from outside. Edges are numbered
/// as the faces meet them and run as they are met first.
/// @throws Error invalid_argument  a vertex out of range, a face of fewer than two corners, two equal corners
/// in a row
EdgeGraph edge_graph(int vertex_count, const std::vector<std::vector<int>>& faces);

/// Vertices around a loop, in its sense: the first vertex of each use.
std::vector<VertexId> corners(const EdgeGraph& graph, const std::vector<EdgeUse>& loop);

/// Where each edge is used.
std::vector<std::vector<EdgeGraph::Place>> places(const EdgeGraph& graph);

/// Number of edge ends at each vertex; a closed edge counts twice.
std::vector<int> degrees(const EdgeGraph& graph);

/// Whether and where a graph fails to be the boundary of a solid.
struct BoundaryReport {
  std::vector<EdgeId> free_edges;          ///< with one face
  std::vector<EdgeId> overused_edges;      ///< with more than two
  std::vector<EdgeId> misoriented_edges;   ///< walked twice in the same direction
  std::vector<VertexId> pinched_vertices;  ///< whose faces make more than one fan
  int shells = 0;                          ///< connected components of faces, over edges

  bool closed() const { return free_edges.empty(); }
  bool manifold() const { return overused_edges.empty() && pinched_vertices.empty(); }
  bool oriented() const { return misoriented_edges.empty(); }
  bool bounds_a_solid() const { return closed() && manifold() && oriented() && shells > 0; }
};
BoundaryReport boundary(const EdgeGraph& graph);

/// What kind of solid a boundary makes.
struct TopologyReport {
  int euler_characteristic = 0;  ///< V - E + the characteristic of each open face, one less its inner loops
  int genus = 0;                 ///< handles of all shells together
  std::vector<FaceId> with_inner_loops;
  std::vector<FaceId> periodic;      ///< with a seam: an edge that they use twice
  std::vector<EdgeId> closed_edges;  ///< that start where they end

  /// One shell without handles: a ball. Its faces may still have inner loops or seams.
  bool contractible = false;
  /// And every face is a disc whose boundary passes no edge twice.
  bool faces_are_discs() const { return with_inner_loops.empty() && periodic.empty(); }
};
/// @param boundary  of the same graph; genus and contractibility are 0 and false unless it bounds a solid
TopologyReport topology(const EdgeGraph& graph, const BoundaryReport& boundary);

/// V - E + F of one shell, F being 2 - loops for each face: 2 less twice the handles on any closed surface.
struct ShellCharacteristic {
  int value = 0;
  std::vector<FaceId> faces;
};
/// Of each shell, by its lowest face.
std::vector<ShellCharacteristic> shell_characteristics(const EdgeGraph& graph);

}  // namespace isopatch::geometry
