#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// How much is verified: quick takes minutes, full as long as it needs.
enum class VerificationLevel { quick, full };

/// The program that holds the suites, `isopatch-verification`: beside this program, where it is installed, or
/// in the build tree; the variable ISOPATCH_VERIFICATION names another one.
/// @throws Error io, saying where it was looked for and how to build it
std::filesystem::path verification_program();

/// Names of the suites that a level has, such as "closed_forms".
std::vector<std::string> verification_suites(const std::filesystem::path& program, VerificationLevel level);

/// Runs suites and returns their claims, the JSON array that verification/claims/claim_record.hpp describes,
/// with suites named as in `verification_suites` and `case`, the test in words.
///
/// @param suites  some of `verification_suites`; empty: all of the level
/// @throws Error invalid_argument  a suite that does not exist, naming the nearest one
/// @throws Error io                the program cannot be started, or ends without a record, saying in which
/// test
std::string run_verification(const std::filesystem::path& program, const std::vector<std::string>& suites,
                             VerificationLevel level, const Progress& progress = {});

}  // namespace isopatch::app
