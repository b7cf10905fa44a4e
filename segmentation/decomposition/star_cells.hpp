#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// Divides every cell into tetrahedra around a point inside it, every side around a point in the middle: what
/// comes out meets side to side, whatever met in parts before. Many cells, so a last resort: as many as the
/// faces have edges, counted from both sides.
/// @param complex  convex cells with plane faces and straight edges
/// @param centres  of the cells, m: where they are given, cells need not be convex, but be seen whole from
/// there, and faces from their middle
/// @throws Error unsupported  a cell with curved sides or edges
geometry::CellComplex star_cells(const geometry::Brep& source, geometry::CellComplex complex,
                                 const std::vector<Eigen::Vector3d>& centres = {});

}  // namespace isopatch::segmentation
