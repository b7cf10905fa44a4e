#pragma once

#include "verification/claims/claim.hpp"

namespace isopatch::verification {

/// Records a claim and fails the running test if it does not hold, or if it would mean nothing: one that
/// allows more than a tenth, or more than a hundredth without a reason, or has no least with its most.
void expect(const Claim& claim);

/// Records an order of convergence and fails the running test if it does not hold. Needs four levels, and
/// refuses errors below 1e-11, where round-off decides, and an `allowed` above 0.2.
void expect(const Convergence& convergence);

/// Records a figure; no test fails by it.
void report(const Figure& figure);

}  // namespace isopatch::verification
