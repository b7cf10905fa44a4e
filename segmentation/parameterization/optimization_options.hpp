#pragma once

namespace isopatch::segmentation {

/// How control points are moved to make patches better.
struct OptimizationOptions {
  int untangling_rounds = 25;       ///< of a regularization each; range 0 .. 1000
  int untangling_evaluations = 60;  ///< of the energy, a round; range 1 .. 100000
  int quality_evaluations = 60;     ///< range 0 .. 100000
  bool operator==(const OptimizationOptions&) const = default;
};

}  // namespace isopatch::segmentation
