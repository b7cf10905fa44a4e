#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {

/// Computes one result for each of many elements in parallel and consumes them in order, batch by batch, so
/// that what is summed does not depend on the number of threads and memory stays that of one batch.
///
/// @param batch    results alive at once
/// @param compute  (element, Scratch&, Result&): in parallel, one Scratch a thread, results' storage is used
/// again
/// @param consume  (first element, std::span<const Result>): by one thread
template <class Scratch, class Result, class Compute, class Consume>
void in_batches(std::int64_t count, std::int64_t batch, Compute compute, Consume consume) {
  constexpr std::int64_t per_task = 8;
  std::vector<Scratch> scratch(static_cast<std::size_t>(omp_get_max_threads()));
  std::vector<Result> results(static_cast<std::size_t>(std::min(batch, count)));
  for (std::int64_t start = 0; start < count; start += batch) {
    const std::int64_t here = std::min(batch, count - start);
    parallel_for((here + per_task - 1) / per_task, [&](std::int64_t task, int thread) {
      const std::int64_t last = std::min(here, (task + 1) * per_task);
      for (std::int64_t i = task * per_task; i < last; ++i)
        compute(start + i, scratch[static_cast<std::size_t>(thread)], results[static_cast<std::size_t>(i)]);
    });
    consume(start, std::span<const Result>(results.data(), static_cast<std::size_t>(here)));
  }
}

}  // namespace isopatch::iga
