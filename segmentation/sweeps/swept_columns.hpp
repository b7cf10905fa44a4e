#pragma once

#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// A solid as columns of hexahedra over quadrilaterals of its profile.
struct SweptCells {
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  Eigen::Vector3d along;          ///< unit
  int quadrilaterals = 0, levels = 0;
  int rounds = 0;  ///< concave ones along floors, which are kept
};

}  // namespace isopatch::segmentation
