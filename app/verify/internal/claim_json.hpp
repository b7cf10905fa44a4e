#pragma once

// For .cpp files only: third-party types stay out of the headers that others include.

#include "app/base/internal/json_values.hpp"
#include "app/verify/verified_claim.hpp"

namespace isopatch::app {

/// A claim as verify.json has it.
Json claim_json(const VerifiedClaim& claim);

}  // namespace isopatch::app
