#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/base/choices.hpp"
#include "app/verify/verified_claim.hpp"
#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// How much is verified: quick takes minutes, full as long as it needs.
enum class VerificationLevel { quick, full };
/// "quick", "full".
const Choices<VerificationLevel>& verification_levels();

/// The program that holds the suites, `isopatch-verification`: beside this program, where it is installed, or
/// in the build tree; the variable ISOPATCH_VERIFICATION names another one.
/// @throws Error io, saying where it was looked for and how to build it
std::filesystem::path verification_program();

/// Names of the suites that a level has, such as "closed_forms".
std::vector<std::string> verification_suites(const std::filesystem::path& program, VerificationLevel level);

/// Runs suites and returns their claims, with suites named as in `verification_suites` and tests in words.
///
/// @param suites  some of `verification_suites`; empty: all of the level
/// @throws Error invalid_argument  a suite that does not exist, naming the nearest one
/// @throws Error io                the program cannot be started, or ends without a record, saying in which
/// test
std::vector<VerifiedClaim> run_verification(const std::filesystem::path& program,
                                            const std::vector<std::string>& suites, VerificationLevel level,
                                            const Progress& progress = {});

}  // namespace isopatch::app
