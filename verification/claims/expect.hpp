#pragma once

#include "verification/claims/claim.hpp"

namespace isopatch::verification {

/// Records a claim and fails the running test if it does not hold. Refuses an `allowed` above 0.1: a value
/// that may be anything up to a limit says so with `least`.
void expect(const Claim& claim);

/// Records an order of convergence and fails the running test if it does not hold. Needs four levels, and
/// refuses errors below 1e-11, where round-off decides, and an `allowed` above 0.2.
void expect(const Convergence& convergence);

/// Records a figure; no test fails by it.
void report(const Figure& figure);

}  // namespace isopatch::verification
