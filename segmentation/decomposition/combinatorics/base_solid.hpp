#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation {

/// Solids that templates turn into hexahedra. A tetrahedron is no pyramid here, a hexahedron no prism; simple
/// is any other of which three edges meet at every vertex, convex any other without non-convex edges.
enum class BaseKind { hexahedron, prism, tetrahedron, pyramid, simple, convex };
const char* name(BaseKind kind);

/// A cell whose graph is that of a base solid, and which vertex is which.
struct BaseSolid {
  BaseKind kind = BaseKind::hexahedron;
  /// Corners of the base; of a simple solid its vertices; of a convex one the tetrahedra around a point
  /// inside it.
  int sides = 4;
  /// The base, counter-clockwise seen from inside the solid, starting at its lowest vertex; then the apex, or
  /// the top vertex over each corner of the base. The base is the first face that can be one.
  std::vector<VertexId> corners;
  FaceId base;
  bool operator==(const BaseSolid&) const = default;
};

/// By the graph alone, whatever the kinds of edges; never a simple one. For a graph that bounds a ball.
std::optional<BaseSolid> base_solid(const CellGraph& graph);

/// A graph with three edges at every vertex as a simple solid; its corners are not listed.
std::optional<BaseSolid> simple_solid(const CellGraph& graph);

/// Any graph as a convex solid, whatever the kinds of edges; its corners are not listed.
BaseSolid convex_solid(const CellGraph& graph);

/// How many hexahedra the templates make of a base solid: hexahedron 1, tetrahedron 4, pyramid over n corners
/// 4 (n - 2), prism over n corners (n - 2) / 2 if n is even, else (n - 3) / 2 and three more; a simple solid
/// one a vertex, a convex one 4 a tetrahedron.
int template_hexahedra(BaseKind kind, int sides);

}  // namespace isopatch::segmentation
