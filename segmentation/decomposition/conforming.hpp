#pragma once

#include "geometry/base/progress.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/decomposition_options.hpp"
#include "segmentation/decomposition/decomposition_report.hpp"

namespace isopatch::segmentation {

/// Makes all cells meet side to side: an edge that divides a side is carried on by a cut through the cell,
/// and so on through its neighbours; cells that are then no base solids are cut further.
/// @param report  counts T-joints and further cuts
/// @throws Error unsupported  a cell that cannot be cut along such an edge, or more cells than allowed
geometry::CellComplex conforming(const geometry::Brep& source, geometry::CellComplex complex,
                                 const DecompositionOptions& options, DecompositionReport& report,
                                 const Progress& progress = {});

}  // namespace isopatch::segmentation
