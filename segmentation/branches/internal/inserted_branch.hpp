#pragma once

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/branches/internal/branch_place.hpp"
#include "segmentation/branches/internal/main_body.hpp"

namespace isopatch::segmentation {

/// Replaces the column of hexahedra below a place by those over a drawing of the branch's outlines.
/// @param solid     whose faces are named
/// @param cut_face  what sides on its top are on, if more stands there
/// @throws Error unsupported  the drawing cannot be divided, the body is not as it has to be there
geometry::CellComplex inserted_branch(const geometry::Brep& solid, const geometry::CellComplex& body,
                                      const Branch& branch, const BranchPlace& place, FaceId cut_face);

}  // namespace isopatch::segmentation
