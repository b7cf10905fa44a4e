#pragma once

#include <deque>
#include <optional>
#include <set>
#include <vector>

#include "segmentation/decomposition/combinatorics/canonical_code.hpp"
#include "segmentation/decomposition/combinatorics/internal/loop_candidates.hpp"

namespace isopatch::segmentation {

/// A cut that the oracle has made.
struct CutOption {
  CuttingLoop loop;
  std::vector<int> pieces;  ///< numbers of cells
  double penalty = 0;
};

/// All cells that a search has met, each with the cuts that were tried on it so far.
class SearchCells {
 public:
  struct Entry {
    SearchCell cell;
    std::optional<BaseSolid> base;   ///< if it is accepted as one
    double cost = 0;                 ///< `cell_cost`, or the templates' hexahedra
    std::optional<BaseSolid> other;  ///< a simple or convex solid, if it may stay as one
    double other_cost = 0;
    std::size_t fingerprint = 0;  ///< of its code with kinds of edges
    std::vector<CutOption> options;
    CandidateStage stage = CandidateStage::none;
    int batch = -1;  ///< of the stage; -1 before the first
    std::vector<LoopCandidate> candidates;
    std::size_t next_candidate = 0;
    std::set<CuttingLoop> tried;  ///< in normal form
    int refusals = 0;
  };

  SearchCells(const SearchOracle& oracle, const SearchOptions& options)
      : oracle_(oracle), options_(options) {}

  /// The number of a new cell, -1 for one that is not 3-connected.
  int add(SearchCell cell);
  const Entry& entry(int number) const { return entries_[static_cast<std::size_t>(number)]; }

  /// The first `wanted` cuts of a cell that the oracle makes, fewer if there are no more; it is asked as far
  /// as necessary.
  const std::vector<CutOption>& options(int number, int wanted);

  int evaluations() const { return evaluations_; }
  int refusals() const { return refusals_; }

 private:
  std::optional<BaseSolid> other_solid(const SearchCell& cell) const;
  bool prepare_next_batch(Entry& entry);
  void try_next(int number);

  const SearchOracle& oracle_;
  const SearchOptions& options_;
  HexahedraCount count_;
  std::deque<Entry> entries_;
  int evaluations_ = 0, refusals_ = 0;
};

}  // namespace isopatch::segmentation
