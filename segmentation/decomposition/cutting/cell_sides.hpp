#pragma once

#include <vector>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"
#include "segmentation/decomposition/cutting/cell_shapes.hpp"

namespace isopatch::segmentation {

/// A cell as combinatorics sees it, and what its vertices, edges and faces are in the complex.
struct CellSides {
  CellGraph graph;
  std::vector<VertexId> vertices;  ///< by vertex of the graph
  std::vector<std::vector<geometry::EdgeUse>>
      edges;  ///< by edge of the graph: one after the other, start to end
  std::vector<std::vector<geometry::CellFaceUse>> faces;  ///< by face of the graph: those of one side
};

struct SideOptions {
  /// Angles that differ less from 180 degrees count as flat.
  Angle flat = Angle::degrees(2.5);
  bool operator==(const SideOptions&) const = default;
};

/// Whether all faces of a cell are plane and all edges straight.
bool is_polyhedral(const CellShapes& shapes, geometry::CellId cell);

/// The sides of a cell, with the angles between them. Vertices where two sides meet and no third do not
/// count.
/// @throws Error unsupported  a side that is no disc, or two sides that meet along two edges
CellSides cell_sides(const CellShapes& shapes, geometry::CellId cell, const SideOptions& options = {});

}  // namespace isopatch::segmentation
