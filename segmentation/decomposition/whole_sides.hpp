#pragma once

#include <vector>

#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// Gives cells sides of their own, of one face and four corners each, where a side was several faces or an
/// edge of it several: what is left then meets its neighbours without sharing faces with them. A side that
/// belongs to one face of the source only in part belongs to none.
/// @param cells  those that get them
/// @throws Error unsupported  faces of a side that lie neither on one surface nor in one plane; pieces of an
///                            edge that belong to several curves and are not straight
void make_sides_whole(const geometry::Brep& source, geometry::CellComplex& complex,
                      const std::vector<geometry::CellId>& cells, const SideOptions& options = {});

}  // namespace isopatch::segmentation
