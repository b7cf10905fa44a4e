#pragma once

#include <set>
#include <vector>

#include "geometry/base/union_find.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// Which edges templates divide: those of sides without four corners, and those that a side with four corners
/// has across from one that is divided. The edges that a side of a cell has in one row are divided together.
class DividedEdges {
 public:
  /// @param cells  the sides of every cell
  DividedEdges(const geometry::CellComplex& complex, const std::vector<CellSides>& cells);
  bool contains(EdgeId edge) const { return divided_.contains(together_.find(edge.value)); }

 private:
  UnionFind together_;
  std::set<int> divided_;  // of the edges that represent those divided together
};

}  // namespace isopatch::segmentation
