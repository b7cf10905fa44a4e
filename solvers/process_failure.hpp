#pragma once

#include <vector>

#include "solvers/processes.hpp"

namespace isopatch::solvers {

/// A failure of this process, to be made as soon as it is known: one of the processes that fail reports, and
/// none waits for ever for another.
class ProcessFailure {
 public:
  /// Tells the others, and listens for two seconds whether a lower process has failed too.
  explicit ProcessFailure(const Processes& processes);

  /// Whether this process is the one to report.
  bool is_to_report() const { return is_to_report_; }
  /// Returns if all processes have failed, so that each can end by itself; else, after two seconds, ends them
  /// all with the exit code.
  void leave_or_abort(int exit_code);

 private:
  std::vector<int> silent_;  // those that have not failed as far as is known
  bool is_to_report_ = true;
};

}  // namespace isopatch::solvers
