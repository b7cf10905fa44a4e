#pragma once

#include <array>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/output/internal/grid_fields.hpp"

namespace isopatch::iga {

/// The intervals into which one direction of a patch is cut for sampling.
struct DirectionPieces {
  std::vector<int> ends;    ///< chosen ends of elements: indices of breaks, first and last included
  std::vector<int> counts;  ///< pieces between one chosen end and the next
};
using PatchPieces = std::array<DirectionPieces, 3>;

/// Chooses the sampling intervals of all patches, equal on both sides of every interface.
///
/// The deviation of a trial grid from straight lines between the ends of elements asks for the pieces; it
/// falls with their square. Too many points in all: larger tolerances, then several elements a piece.
/// @param is_coarse  set where the tolerances are not reached
/// @throws Error not_conforming  an interface whose sides have different numbers of elements
std::vector<PatchPieces> choose_pieces(const geometry::MultiPatch& model,
                                       const std::vector<SampledPatch>& patches,
                                       const SamplingOptions& options, bool& is_coarse);

}  // namespace isopatch::iga
