#pragma once

#include <memory>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation {

/// The smallest number of hexahedra that cuts along valid loops, without auxiliary vertices, and the
/// templates of hexahedra, prisms over triangles and tetrahedra make of a cell; geometry and kinds of edges
/// ignored.
///
/// Remembers what it has counted, by canonical code, so keep it. Not for several threads at once.
class HexahedraCount {
 public:
  HexahedraCount();
  ~HexahedraCount();
  HexahedraCount(HexahedraCount&&) noexcept;
  HexahedraCount& operator=(HexahedraCount&&) noexcept;

  /// @cost  grows about tenfold with every two vertices: with nothing remembered a tenth of a second for 13
  /// @throws Error not_three_connected
  int minimum(const CellGraph& graph);

  /// The minimum of cells of no more vertices than `exact_up_to`, the minimum of the templates for base
  /// solids, else a guess from the sizes of faces and the degrees of vertices.
  /// @throws Error not_three_connected
  double estimate(const CellGraph& graph, int exact_up_to);

  /// How many cells are remembered.
  int remembered() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace isopatch::segmentation
