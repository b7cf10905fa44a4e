#pragma once

#include <string>
#include <vector>

#include "app/pages/page.hpp"
#include "app/verify/verification_run.hpp"
#include "app/verify/verified_claim.hpp"

namespace isopatch::app {

/// How many claims of a verification hold.
struct VerificationCounts {
  int hold = 0;
  int fail = 0;
  int not_run = 0;   ///< what they need is not there
  int reported = 0;  ///< figures that claim nothing
};
VerificationCounts count_claims(const std::vector<VerifiedClaim>& claims);

/// verify.json; SUMMARY.md documents its keys.
/// @param claims   as `run_verification` returns them
/// @param seconds  that the suites took
std::string verification_json(const std::vector<VerifiedClaim>& claims, VerificationLevel level,
                              double seconds);

/// The table for the terminal, and for each failing claim the command that shows it alone.
std::string verification_text(const std::vector<VerifiedClaim>& claims);

/// verify.html, with the plots of `verification_plots`.
/// @param json    text of verify.json
/// @param claims  of which it is made
Page verification_page(const std::string& json, const std::vector<VerifiedClaim>& claims);

}  // namespace isopatch::app
