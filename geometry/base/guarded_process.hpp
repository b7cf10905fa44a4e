#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace isopatch {

/// How much a guarded program may use.
struct GuardLimits {
  double seconds = 120;     ///< of computing; a program that only waits may do so five times as long. Above 0
  std::uint64_t bytes = 0;  ///< of address space; 0 for as much as there is
  bool operator==(const GuardLimits&) const = default;
};

/// A program to run in a child process with limits, because it may crash, hang or want all the memory there
/// is.
struct GuardedCommand {
  std::filesystem::path program;
  std::vector<std::string> arguments = {};
  std::string_view input = {};  ///< what it finds on its standard input
  GuardLimits limits = {};
  /// Gets each line of its standard output, without the end, while it runs.
  std::function<void(std::string_view line)> on_line = {};
};

/// Outcome of a guarded program.
struct GuardedOutcome {
  enum class End {
    exited,     ///< by itself, with `code`
    signalled,  ///< by the signal `code`
    timed_out,  ///< it was stopped at the limit
  };
  End end = End::exited;
  int code = 0;
  std::string result;  ///< what it wrote to file descriptor 3
  std::string errors;  ///< the end of what it wrote to its standard error, 4,000 characters at most

  bool succeeded() const { return end == End::exited && code == 0; }
  /// "ended by signal 11 (Segmentation fault)", "was stopped after 120 s", "ended with code 3".
  std::string text(const GuardLimits& limits) const;
};

/// Runs a program to its end or to its limits; whatever it does, the caller lives on.
///
/// The program inherits nothing but the three standard streams and descriptor 3, and ends when the caller's
/// thread does.
/// @throws Error io  it cannot be started
/// @cost   a few milliseconds besides the program
GuardedOutcome run_guarded(const GuardedCommand& command);

}  // namespace isopatch
