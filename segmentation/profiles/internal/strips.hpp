#pragma once

#include <optional>
#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/search.hpp"

namespace isopatch::segmentation::planar {

/// Quadrilaterals in a row, each entered by one side and left by the opposite one, from outline to outline or
/// around: what a line between their rungs divides.
struct Strip {
  std::vector<Side> rungs;  ///< the sides between them and at both ends, as their left ends see them
};

/// All strips of a mesh of quadrilaterals but those that cross themselves.
std::vector<Strip> strips_of(const CellMesh& mesh);

/// The mesh without the quadrilaterals of a strip: the ends of each rung become one node, in the middle where
/// both may move.
/// @return nothing where two nodes would meet that cannot: vertices of the profile, cuts of different edges
/// @cost linear in the cells
std::optional<CellMesh> without_strip(const std::vector<Curve>& curves, const CellMesh& mesh,
                                      const Strip& strip);

/// Takes strips out, across all regions, as long as that costs less: what searches of single regions cannot
/// do, since cuts of shared edges are the same for both. Corners stay between 25 and 155 degrees and
/// Jacobians above 0.25, or as good as they were.
/// @param windows  divided anew whenever no strip can be taken out
/// @return  the mesh itself if it has triangles or breaks the rules
/// @cost  some 10 milliseconds a strip and 100 cells
CellMesh with_fewer_strips(const SearchInput& input, CellMesh mesh, int windows);

}  // namespace isopatch::segmentation::planar
