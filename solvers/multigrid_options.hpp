#pragma once

namespace isopatch::solvers {

/// How a multigrid smooths.
struct MultigridOptions {
  /// Degree of the Chebyshev polynomial before and after each coarse correction. Range 1 .. 20.
  int smoothing_degree = 4;
  /// The smoother acts on eigenvalues from the largest down to the largest over this. Range 1.1 .. 1000.
  double smoothing_range = 40;
  /// Steps of conjugate gradients that estimate the largest eigenvalue. Range 2 .. 100.
  int eigenvalue_steps = 15;
  bool operator==(const MultigridOptions&) const = default;
};

}  // namespace isopatch::solvers
