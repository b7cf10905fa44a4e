#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"

namespace isopatch::segmentation {

struct ConformingOptions {
  CutOptions cut = {};      ///< limits of what the further cuts may make
  int beam = 10;            ///< complexes kept after each round; range 1 ..
  int branches = 6;         ///< cuts of one cell that are followed; range 1 ..
  int max_hexahedra = 500;  ///< ways to more than so many are given up; range 1 ..
  double time_limit = 30;   ///< seconds of computing, after which the best so far is taken; above 0
};

/// Cells that meet side to side, each with three edges at every vertex.
struct ConformingCells {
  geometry::CellComplex complex;
  std::size_t start = 0;  ///< which complex it came of
  int further_cuts = 0;   ///< made in it
  double hexahedra = 0;   ///< that templates will make of it
};

/// What came of it: the best, or why there is none.
struct ConformingAttempt {
  std::optional<ConformingCells> best;
  std::string refusal = {};  ///< in words
};

/// Makes all cells meet side to side: a chord on a side is carried on by a cut through the cell, and so on
/// through its neighbours; vertices with more than three edges are cut through.
///
/// A beam search from all complexes at once: a round closes one cell of each in its best few ways and keeps
/// those of which the fewest hexahedra are to be expected.
ConformingAttempt conforming(const geometry::Brep& source, const std::vector<geometry::CellComplex>& starts,
                             const ConformingOptions& options = {}, const Progress& progress = {});

}  // namespace isopatch::segmentation
