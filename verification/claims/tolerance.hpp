#pragma once

#include <string>

namespace isopatch::verification {

/// How much may differ, and why so much where that is far more than is found.
struct Tolerance {
  // NOLINTNEXTLINE(google-explicit-constructor): most tolerances are a number alone
  Tolerance(double value = 0, std::string because = "") : most(value), reason(std::move(because)) {}

  double most = 0;
  std::string reason;
};

/// Other processors, numbers of threads and orders of summation round differently: by this factor a bound on
/// round-off is larger than what has been seen.
constexpr double round_off_safety = 16;

/// What round-off explains: unit round-off times what it is multiplied by, times `round_off_safety`.
/// @param amplification  a number of operations, or how much a solve has been seen to enlarge round-off
/// @param of             what enlarges it: "two factorizations"
Tolerance round_off(double amplification, const std::string& of);

}  // namespace isopatch::verification
