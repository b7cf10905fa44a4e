#pragma once

#include <vector>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation {

/// Faces as cycles of vertices, counter-clockwise seen from outside, one after the other in one list: small
/// and quick to copy.
struct PlanarMap {
  int vertices = 0;
  std::vector<int> corners;
  std::vector<int> begin = {0};  ///< of face f in `corners`; its end is the next one's begin

  int faces() const { return static_cast<int>(begin.size()) - 1; }
  int size(int face) const { return begin[face + 1] - begin[face]; }
  void end_face() { begin.push_back(static_cast<int>(corners.size())); }
};
PlanarMap planar_map(const CellGraph& graph);
CellGraph cell_graph(const PlanarMap& map);

/// How the sides of faces are connected. Dart d is the side that starts at corner d of the list.
struct Darts {
  std::vector<int> next, previous;  ///< around the face
  std::vector<int> twin;            ///< the same edge from the other side, -1 if there is none
  std::vector<int> face;
  std::vector<int> out_begin, out;  ///< of vertex v: the darts that start there, in no order

  /// The dart from a to b, -1 if there is none.
  int between(const PlanarMap& map, int a, int b) const;
};
Darts darts(const PlanarMap& map);

/// Whether every dart has one twin, the faces at each vertex make one fan, and V - E + F = 2 on one shell.
bool is_sphere(const PlanarMap& map, const Darts& darts);

/// For a sphere: see `is_three_connected` of a graph.
bool is_three_connected(const PlanarMap& map, const Darts& darts);

}  // namespace isopatch::segmentation
