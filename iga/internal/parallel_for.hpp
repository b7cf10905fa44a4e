#pragma once

#include <omp.h>

#include <cstdint>
#include <exception>

namespace isopatch::iga {

/// Calls body(index, thread) for every index from 0 to count, in parallel and in any order. An exception, of
/// the smallest index that throws among those that ran, comes out as from a plain loop.
template <class Body>
void parallel_for(std::int64_t count, Body body) {
  std::exception_ptr failure;
  std::int64_t failed = count;
#pragma omp parallel for schedule(dynamic, 1) if (count > 1)
  for (std::int64_t i = 0; i < count; ++i) {
    try {
      body(i, omp_get_thread_num());
    } catch (...) {
#pragma omp critical(isopatch_parallel_for)
      if (i < failed) {
        failed = i;
        failure = std::current_exception();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace isopatch::iga
