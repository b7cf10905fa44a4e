#pragma once

#include <optional>
#include <string>

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"

namespace isopatch::segmentation {

/// Why a loop does not cut a 3-connected cell into two 3-connected pieces, in words; nothing if it does.
///
/// A loop without extensions is valid iff it has three places or more and every face has at most two of them,
/// which follow each other in the loop. Whether it makes sense in space is for geometry to say.
/// A loop with extensions is cut and both pieces are looked at.
/// @cost without extensions O(places times degree), with them that of `cut_along`
std::optional<std::string> why_invalid(const CellGraph& graph, const CellIncidence& incidence,
                                       const CuttingLoop& loop);

}  // namespace isopatch::segmentation
