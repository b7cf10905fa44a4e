#pragma once

#include "segmentation/profiles/internal/search.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"

namespace isopatch::segmentation::planar {

/// The best of several searches.
struct DraftedMesh {
  CellMesh mesh;
  double cost = 0;
  bool is_valid = false;  ///< else it has triangles, or poor quadrilaterals
};
DraftedMesh drafted_mesh(const SearchInput& input, const Profile& profile,
                         const QuadrangulationOptions& options);

/// In quadrilaterals: of a thorough search without rows that are not needed; if no search was successful,
/// with each cell divided around its middle.
/// @throws DivisionError  that is folded; says the region, and where in the profile's standard position
CellMesh finished_mesh(const SearchInput& input, const DraftedMesh& draft,
                       const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation::planar
