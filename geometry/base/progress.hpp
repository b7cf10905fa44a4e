#pragma once

#include <functional>
#include <string_view>

namespace isopatch {

/// Callback by which long computations report their progress. The default ignores it.
struct Progress {
  /// Called with the name of the phase and its finished share in [0, 1]; always from one thread at a time.
  std::function<void(std::string_view phase, double share)> report;

  void operator()(std::string_view phase, double share) const {
    if (report) report(phase, share);
  }
};

}  // namespace isopatch
