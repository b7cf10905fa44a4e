#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/base/exit_code.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/console.hpp"

namespace isopatch::app {

struct VerifyCommand {
  std::vector<std::string> suites;  ///< empty: all
  std::string level = "quick";      ///< of `verification_levels`
  bool list = false;
  std::filesystem::path output = "results/verification";
};
/// Runs the verification suites, writes verify.json and verify.html, prints the table; `failed` if a claim
/// fails.
ExitCode verify_command(const VerifyCommand& command, const Console& console);

void add_verify_command(CLI::App& app, CommandLine& line);

}  // namespace isopatch::app
