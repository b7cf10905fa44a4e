#pragma once

#include "segmentation/decomposition/search_cell.hpp"

namespace isopatch::segmentation {

/// Whether templates make hexahedra of a base solid as it is: a hexahedron, a prism over a triangle, a
/// tetrahedron.
bool is_finished(const BaseSolid& base);

/// Cuts by geometry.
/// @param store  must outlive it
SearchOracle geometric_oracle(CellStore& store);

}  // namespace isopatch::segmentation
