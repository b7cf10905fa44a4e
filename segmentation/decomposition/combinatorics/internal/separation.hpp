#pragma once

#include <optional>
#include <string>

#include "segmentation/decomposition/combinatorics/origin.hpp"

namespace isopatch::segmentation {

/// The pieces of a cut, or why there are none.
struct Separation {
  std::optional<CutPieces> pieces;
  std::string fault;
};
/// `cut_along` that says what is wrong with a loop instead of throwing, for loops whose places and steps
/// exist.
Separation separate(const CellGraph& graph, const CuttingLoop& loop);

}  // namespace isopatch::segmentation
