#include "segmentation/decomposition/combinatorics/cut_along.hpp"

#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/internal/separation.hpp"

namespace isopatch::segmentation {

CutPieces cut_along(const CellGraph& graph, const CuttingLoop& loop) {
  Separation result = separate(graph, loop);
  if (!result.pieces)
    throw Error(ErrorCode::invalid_argument,
                "a cell cannot be cut along a loop: " + result.fault + "; ask why_invalid before");
  return std::move(*result.pieces);
}

}  // namespace isopatch::segmentation
