#pragma once

#include <ctime>

namespace isopatch {

/// Seconds that the processor has worked for this process since it was made, of all its threads together:
/// what is limited by them comes out the same on a busy machine.
class ProcessorStopwatch {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

}  // namespace isopatch
