#include "app/verify/verification_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"
#include "geometry/base/temporary_folder.hpp"

namespace isopatch::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view full_prefix = "Full";

// For the shell.
std::string shell_word(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

// Runs a command of the shell and hands on what it prints, line by line. Returns its status as wait() has it.
int for_each_line(const std::string& command, const std::function<void(const std::string&)>& visit) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw Error(ErrorCode::io, "cannot start a process: " + command);
  std::string line;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    visit(line);
    line.clear();
  }
  if (!line.empty()) visit(line);
  return ::pclose(pipe);
}

// "FullClosedForms" and "ClosedForms" as "closed_forms".
std::string suite_name(std::string_view test_suite) {
  if (test_suite.starts_with(full_prefix)) test_suite.remove_prefix(full_prefix.size());
  std::string name;
  for (const char c : test_suite) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0 && !name.empty()) name += '_';
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

// "ThickCylinder" as "thick cylinder".
std::string words(std::string name) {
  name = suite_name(name);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Names of GoogleTest's suites, such as "ClosedForms", that the level has.
std::vector<std::string> test_suites(const fs::path& program, VerificationLevel level) {
  std::vector<std::string> result;
  for_each_line(shell_word(program.string()) + " --gtest_list_tests", [&](const std::string& line) {
    if (line.empty() || line[0] == ' ' || line.find('.') == std::string::npos) return;
    const std::string name = line.substr(0, line.find('.'));
    if (level == VerificationLevel::full || !name.starts_with(full_prefix)) result.push_back(name);
  });
  if (result.empty()) throw Error(ErrorCode::io, program.string() + " has no suites: build it again");
  return result;
}

void check_names(const std::vector<std::string>& suites, const std::vector<std::string>& known) {
  for (const std::string& name : suites)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("there is no suite '{}'{}; there are {}", name, did_you_mean(name, known),
                              fmt::join(known, ", ")));
}

std::string filter(const std::vector<std::string>& of_level, const std::vector<std::string>& wanted) {
  std::vector<std::string> patterns;
  for (const std::string& name : of_level)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), suite_name(name)) != wanted.end())
      patterns.push_back(name + ".*");
  return fmt::format("{}", fmt::join(patterns, ":"));
}

}  // namespace

const Choices<VerificationLevel>& verification_levels() {
  static const Choices<VerificationLevel> levels = {{"quick", VerificationLevel::quick},
                                                    {"full", VerificationLevel::full}};
  return levels;
}

fs::path verification_program() {
  constexpr const char* name = "isopatch-verification";
  if (const char* named = std::getenv("ISOPATCH_VERIFICATION")) return named;
  std::error_code unknown;
  const fs::path here = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  const std::array<fs::path, 2> places = {here / name, here.parent_path() / "verification" / "suites" / name};
  for (const fs::path& place : places)
    if (fs::exists(place, unknown)) return place;
  throw Error(
      ErrorCode::io,
      fmt::format("{} is neither in {} nor in {}; build it with scripts/setup {}, or name it by the variable "
                  "ISOPATCH_VERIFICATION",
                  name, places[0].parent_path().string(), places[1].parent_path().string(), name));
}

std::vector<std::string> verification_suites(const fs::path& program, VerificationLevel level) {
  std::vector<std::string> result;
  for (const std::string& test_suite : test_suites(program, level))
    if (const std::string name = suite_name(test_suite);
        std::find(result.begin(), result.end(), name) == result.end())
      result.push_back(name);
  return result;
}

std::vector<VerifiedClaim> run_verification(const fs::path& program, const std::vector<std::string>& suites,
                                            VerificationLevel level, const Progress& progress) {
  check_names(suites, verification_suites(program, level));
  const std::vector<std::string> of_level = test_suites(program, level);
  const TemporaryFolder folder;
  const fs::path record = folder.path() / "claims.json";
  const std::string command = fmt::format(
      "ISOPATCH_CLAIMS={} exec {} --gtest_color=no --gtest_filter={} 2>&1", shell_word(record.string()),
      shell_word(program.string()), shell_word(filter(of_level, suites)));
  std::string running;
  const int status = for_each_line(command, [&](const std::string& line) {
    constexpr std::string_view run = "[ RUN      ] ";
    if (!line.starts_with(run)) return;
    running = line.substr(run.size());
    progress("verifying " + running, 0);
  });
  if (!fs::exists(record))
    throw Error(ErrorCode::io,
                fmt::format("{} {} without a record{}", program.string(),
                            WIFSIGNALED(status) ? fmt::format("was ended by signal {}", WTERMSIG(status))
                                                : fmt::format("ended with code {}", WEXITSTATUS(status)),
                            running.empty() ? "" : ", in " + running));
  std::vector<VerifiedClaim> claims = read_claims(read_file(record));
  for (VerifiedClaim& claim : claims) {
    claim.suite = suite_name(claim.suite);
    claim.part = words(claim.test);
  }
  return claims;
}

}  // namespace isopatch::app
