#pragma once

#include <vector>

#include "geometry/brep/read_brep.hpp"
#include "segmentation/decomposition/decompose.hpp"

namespace isopatch::segmentation {

/// The cells of a decomposition as solids called "part", "part#1", "part#2", ... after the one that they are
/// parts of. Faces that are parts of its faces have their names and colours; faces between cells have no
/// names.
std::vector<geometry::BrepFile> blocks(const geometry::BrepFile& solid, const Decomposition& decomposition);

/// A face between two of these blocks: which of them, and its number in each.
struct BlockContact {
  int first_block = 0, first_face = 0, second_block = 0, second_face = 0;
};

/// All of them, where blocks meet side to side.
std::vector<BlockContact> block_contacts(const Decomposition& decomposition);

}  // namespace isopatch::segmentation
