#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "geometry/base/progress.hpp"

namespace isopatch::app {

/// Where the program writes, and what it may do there.
struct Console {
  std::ostream& out;             ///< results
  std::ostream& err;             ///< progress, warnings and errors
  bool err_is_terminal = false;  ///< progress may be rewritten in place
  bool colours = false;          ///< bold and red for warnings and errors
  bool quiet = false;            ///< no progress, no summary

  void warn(const std::string& message) const;
  void fail(const std::string& message) const;
};

/// Shows phases: rewritten in place with a percentage on a terminal, one plain line each otherwise. What a
/// phase has behind a tab says how far it is: shown in place of the percentage, on terminals only. The
/// destructor clears the line.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(const Console& console) : console_(console) {}
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Valid as long as the display.
  Progress progress();
  /// Removes an unfinished line from a terminal.
  void clear();

 private:
  void show(std::string_view told, double share);
  const Console& console_;
  std::string phase_, details_;
  int percent_ = -1;
  bool line_open_ = false;
};

}  // namespace isopatch::app
