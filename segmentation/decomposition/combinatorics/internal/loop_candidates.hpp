#pragma once

#include <vector>

#include "segmentation/decomposition/combinatorics/search_options.hpp"
#include "segmentation/decomposition/combinatorics/search_oracle.hpp"

namespace isopatch::segmentation {

/// A loop that a cell may be cut along, and what speaks against it.
struct LoopCandidate {
  CuttingLoop loop;
  double penalty = 0;  ///< without what the pieces cost by themselves
  double total = 0;    ///< with it
};

/// Where loops are looked for, one after the other, as long as no cut has succeeded.
enum class CandidateStage {
  non_convex,    ///< those that extend faces through edges that are not convex, or pass these; of cells that
                 ///< have some
  anywhere,      ///< all through vertices, the constructive one at least
  new_vertices,  ///< short ones with auxiliary vertices anywhere
  none
};

/// The loops to try for a cell at a stage, best first; those proposed are among them. Of many, `considered`
/// are looked at (of those that extend faces three times as many), the next ones in the next batch; none
/// after the last.
std::vector<LoopCandidate> loop_candidates(const SearchCell& cell, const std::vector<CuttingLoop>& proposed,
                                           CandidateStage stage, int batch, HexahedraCount& count,
                                           const SearchOptions& options);

}  // namespace isopatch::segmentation
