#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/branches/internal/main_body.hpp"
#include "segmentation/branches/internal/plan_drawing.hpp"

namespace isopatch::segmentation {

/// Where a branch grows out of a divided body.
struct BranchPlace {
  std::array<Eigen::Vector3d, 4> corners;  ///< of the outer side that it begins on, m
  std::vector<double> floor_radii;         ///< of layers of the body that become floors, in their order
  std::optional<double> top;               ///< height up to which it is made; nothing: it does not stand out
  std::vector<PlanQuad> on_top;            ///< how that is divided which stands on its top; empty: nothing
};

/// Replaces the column of hexahedra below a place by those over a drawing of the branch's outlines.
/// @param solid     whose faces are named
/// @param cut_face  what sides on its top are on, if more stands there
/// @throws Error unsupported  the drawing cannot be divided, the body is not as it has to be there
geometry::CellComplex inserted_branch(const geometry::Brep& solid, const geometry::CellComplex& body,
                                      const Branch& branch, const BranchPlace& place, FaceId cut_face);

}  // namespace isopatch::segmentation
