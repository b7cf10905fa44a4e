#pragma once

#include <string>

#include "app/pages/page.hpp"
#include "app/verify/verification_run.hpp"

namespace isopatch::app {

/// How many claims of a verification hold.
struct VerificationCounts {
  int hold = 0;
  int fail = 0;
  int not_run = 0;   ///< what they need is not there
  int reported = 0;  ///< figures that claim nothing
};
VerificationCounts count_claims(const std::string& claims);

/// verify.json; SUMMARY.md documents its keys.
/// @param claims   as `run_verification` returns them
/// @param seconds  that the suites took
std::string verification_json(const std::string& claims, VerificationLevel level, double seconds);

/// The table for the terminal, and for each failing claim the command that shows it alone.
std::string verification_text(const std::string& claims);

/// verify.html, with the plots of `verification_plots`.
/// @param json  text of verify.json
Page verification_page(const std::string& json);

}  // namespace isopatch::app
