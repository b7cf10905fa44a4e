#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/base/choices.hpp"

namespace isopatch::app {

/// What became of a claim.
enum class Verdict {
  holds,
  fails,
  not_run,   ///< what its test needs is not there
  reported,  ///< a figure that claims nothing
};
/// "holds", "FAILS", "not run", "reported".
const Choices<Verdict>& verdicts();

/// A value beside its reference; nothing where a number is missing or not finite.
struct ClaimFigures {
  std::optional<double> reference;
  std::optional<double> value;
  std::optional<double> difference;
  std::string comparison = {};       ///< "relative", "absolute", "at most", "at least"
  std::optional<double> least = {};  ///< that an "at most" may have
  std::optional<double> allowed = {};
  std::string reason = {};  ///< why so much is allowed
};

/// A study that shows a claim alone.
struct ClaimedStudy {
  std::string file;
  std::vector<std::string> overrides;  ///< "discretization.degree=2"
};

/// Errors over sizes of elements. Not a number: not finite.
struct ClaimedConvergence {
  std::vector<double> sizes;
  std::vector<double> errors;
  std::vector<double> orders;  ///< between neighbouring levels
};

/// A claim as the suites record it; SUMMARY.md documents its keys.
struct VerifiedClaim {
  std::string suite;  ///< "closed_forms"
  std::string part;   ///< its test in words, the key `case`
  std::string test;   ///< the test's name
  std::string what;
  std::string unit = {};
  std::string kind = {};                     ///< of the reference
  std::string source = {};                   ///< of the reference
  std::optional<ClaimFigures> figures = {};  ///< nothing of tests that were not run or broke
  std::optional<std::string> why = {};       ///< a figure is only reported
  std::optional<ClaimedStudy> study = {};
  std::optional<ClaimedConvergence> convergence = {};
  Verdict verdict = Verdict::fails;
};

/// The record of the suites: the JSON array that verification/claims/claim_record.hpp describes, with suites
/// and tests named as the suites' program does. A verdict that is none counts as a failure.
/// @throws Error bad_format  for what is no such array
std::vector<VerifiedClaim> read_claims(const std::string& record);

}  // namespace isopatch::app
