#pragma once

#include <cmath>

namespace isopatch::geometry {

/// A length, area or volume found by quadrature.
struct Measure {
  double value = 0;
  /// Estimate of the quadrature's error, not below it in all our experience; infinite where the geometry
  /// cannot be evaluated. Round-off (1e-15) is not counted.
  double error = 0;

  /// The share of its value that a measure is promised to be right to.
  static constexpr double promised = 1e-7;
  bool converged() const { return error <= promised * std::abs(value); }
};

}  // namespace isopatch::geometry
