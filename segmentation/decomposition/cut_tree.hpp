#pragma once

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/search_cell.hpp"

namespace isopatch::segmentation {

/// The ways that a cell was cut, repeated in a complex that it belongs to, so that its neighbours' sides are
/// divided with its own.
/// @param store  in which the search cut it
/// @return  how many cuts
/// @throws Error unsupported  a cut that the complex refuses
int apply_cuts(const geometry::Brep& source, geometry::CellComplex& complex, geometry::CellId cell,
               const CutTree& tree, const CellStore& store, const CutOptions& options);

}  // namespace isopatch::segmentation
