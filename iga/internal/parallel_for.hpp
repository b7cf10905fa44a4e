#pragma once

#include <omp.h>

#include <cstdint>
#include <exception>

namespace isopatch::iga {

/// Keeps the exception of the smallest index that throws.
class FirstFailure {
 public:
  template <class Body>
  void guard(std::int64_t index, Body& body) {
    try {
      body(index, omp_get_thread_num());
    } catch (...) {
#pragma omp critical(isopatch_parallel_for)
      if (!failure_ || index < index_) {
        index_ = index;
        failure_ = std::current_exception();
      }
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
  std::int64_t index_ = 0;
};

/// Calls body(index, thread) for every index from 0 to count, in parallel and in any order. An exception, of
/// the smallest index that throws among those that ran, comes out as from a plain loop.
template <class Body>
void parallel_for(std::int64_t count, Body body) {
  FirstFailure failure;
#pragma omp parallel for schedule(dynamic, 1) if (count > 1)
  for (std::int64_t i = 0; i < count; ++i) failure.guard(i, body);
  failure.rethrow();
}

/// The same for bodies of equal cost: every thread has a range of its own, and so touches memory of its own
/// if indices follow it. Two threads that first touch one page at once wait for each other while it is
/// cleared.
template <class Body>
void parallel_ranges(std::int64_t count, Body body) {
  FirstFailure failure;
#pragma omp parallel for schedule(static) if (count > 1)
  for (std::int64_t i = 0; i < count; ++i) failure.guard(i, body);
  failure.rethrow();
}

}  // namespace isopatch::iga
