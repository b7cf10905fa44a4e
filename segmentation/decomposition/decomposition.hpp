#pragma once

#include <vector>

#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/decomposition_report.hpp"
#include "segmentation/decomposition/parted_sides.hpp"

namespace isopatch::segmentation {

struct Decomposition {
  /// Of hexahedra that meet side to side; where T-joints are kept also in parts of sides.
  geometry::CellComplex complex;
  geometry::CellComplex parts;       ///< what the search cut the solid into, before sides were made to meet
  std::vector<PartedSide> t_joints;  ///< of `parts`
  DecompositionReport report;
};

}  // namespace isopatch::segmentation
