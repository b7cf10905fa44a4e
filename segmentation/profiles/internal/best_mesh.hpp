#pragma once

#include "segmentation/profiles/internal/search.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"

namespace isopatch::segmentation::planar {

/// The best of several searches, in quadrilaterals; if all of them leave triangles, the best one with each
/// cell divided around its middle.
CellMesh best_mesh(const SearchInput& input, const Profile& profile, const QuadrangulationOptions& options);

}  // namespace isopatch::segmentation::planar
