#pragma once

#include "segmentation/decomposition/search_cell.hpp"

namespace isopatch::segmentation {

/// A solid as the one cell that cuts start from, with its neighbouring plane faces merged.
struct StartingCell {
  geometry::CellComplex complex;
  SearchCell cell;
};

/// @param store  of the solid, which gets the cell
/// @throws SolidError unsupported          a face that is no disc: names it
/// @throws SolidError unsupported          an edge shorter than 1e-6 of the solid's size: names it
/// @throws SolidError unsupported          two hundred triangles and more that stand for smooth faces
/// @throws SolidError not_contractible     a solid with holes through it
/// @throws SolidError not_three_connected  names two faces that meet in more than a vertex or an edge, and
/// where
StartingCell starting_cell(CellStore& store);

}  // namespace isopatch::segmentation
