#pragma once

namespace isopatch {

/// The larger of two numbers, NaN if one of them is: std::max forgets a NaN that comes second, and a largest
/// error would then pass for small. Of a matrix: `maxCoeff<Eigen::PropagateNaN>()`.
template <class Number>
constexpr Number larger(Number a, Number b) {
  const bool is_nan = a != a;
  return is_nan || a > b ? a : b;
}

/// The smaller of two numbers, NaN if one of them is.
template <class Number>
constexpr Number smaller(Number a, Number b) {
  const bool is_nan = a != a;
  return is_nan || a < b ? a : b;
}

}  // namespace isopatch
