#pragma once

#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// Makes hexahedra of the cells of a complex and leaves the T-joints between them.
///
/// Hexahedra stay as they are. Prisms and tetrahedra are divided by `hexahedral` among themselves; what that
/// puts on the sides of hexahedra are T-joints too.
/// @throws Error unsupported  two sides that overlap without one lying in the other; a cell that is no
///                            hexahedron and meets others in parts of its sides
geometry::CellComplex keep_t_joints(const geometry::Brep& source, geometry::CellComplex complex,
                                    double tolerance, const SideOptions& options = {});

}  // namespace isopatch::segmentation
