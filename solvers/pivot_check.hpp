#pragma once

#include <cmath>
#include <cstdint>

namespace isopatch::solvers {

/// A pivot smaller than this times its diagonal entry is taken for zero. (Pivot over diagonal entry is 1
/// without coupling and about 1 / condition at worst.)
///
/// A singular matrix of n rows leaves pivots of some sqrt(n) round-off errors; the 1e-14 is 45 round-off
/// errors. A cantilever of length L and one element of height h across leaves (h / L)^3 / 4, so 1e-10 for L =
/// 1000 h.
inline double smallest_pivot_ratio(std::int64_t rows) {
  return 1e-14 * std::sqrt(static_cast<double>(rows));
}

}  // namespace isopatch::solvers
