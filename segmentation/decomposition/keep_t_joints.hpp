#pragma once

#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// Makes hexahedra of the cells of a complex and leaves the T-joints between them.
///
/// Every cell gets sides of its own, whole where its neighbours have cut them in parts. Hexahedra stay as
/// they are; `hexahedral` divides any other cell by itself. Nothing that divides a cell goes on into its
/// neighbours, so sides meet in parts there as well, and may overlap without one lying in the other.
/// @throws Error unsupported  as `make_sides_whole` and `hexahedral`
geometry::CellComplex keep_t_joints(const geometry::Brep& source, geometry::CellComplex complex,
                                    double tolerance, const SideOptions& options = {});

}  // namespace isopatch::segmentation
