#pragma once

#include <vector>

#include "geometry/brep/read_brep.hpp"
#include "geometry/hex/listed_pair.hpp"
#include "segmentation/decomposition/decompose.hpp"

namespace isopatch::segmentation {

/// The cells of a decomposition as solids called "part", "part#1", "part#2", ... after the one that they are
/// parts of. Faces that are parts of its faces have their names and colours; faces between cells have no
/// names.
std::vector<geometry::BrepFile> blocks(const geometry::BrepFile& solid, const Decomposition& decomposition);

/// The faces between two of these blocks each, where they meet side to side.
std::vector<geometry::ListedPair> block_pairs(const Decomposition& decomposition);

}  // namespace isopatch::segmentation
