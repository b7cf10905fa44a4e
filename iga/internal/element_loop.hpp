#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/discretization.hpp"
#include "iga/element.hpp"

namespace isopatch::iga {

/// @throws Error fold_over for a point of an element with det J <= 0, naming patch, parameter and place
void require_positive_jacobian(const Discretization& discretization, int patch,
                               const ElementEvaluator& evaluator, std::int64_t element,
                               const ElementValues& values);

/// Walks over all elements in batches: each batch is computed in parallel, then consumed.
///
/// @param compute  (patch, ElementValues, Result&): called in parallel
/// @param consume  (patch, const std::vector<Result>&, count): called by one thread, in the order of the
/// elements,
///                 so that what it sums does not depend on the number of threads
/// @param batch_bytes_per_element  what one Result holds; batches stay below 64 MB
template <class Result, class Compute, class Consume>
void for_each_element(const Discretization& discretization, int points, std::int64_t batch_bytes_per_element,
                      const Progress& progress, const char* phase, Compute compute, Consume consume) {
  const int threads = omp_get_max_threads();
  const std::int64_t batch = std::max<std::int64_t>(
      2 * threads, (std::int64_t{64} << 20) / std::max<std::int64_t>(1, batch_bytes_per_element));
  std::vector<Result> results;
  std::vector<ElementValues> values(static_cast<std::size_t>(threads));
  const auto total = static_cast<double>(discretization.element_count());
  std::int64_t done = 0;
  for (int patch = 0; patch < discretization.patch_count(); ++patch) {
    const ElementEvaluator evaluator(discretization.patches[static_cast<std::size_t>(patch)], points);
    for (std::int64_t first = 0; first < evaluator.element_count(); first += batch) {
      const std::int64_t count = std::min(batch, evaluator.element_count() - first);
      results.resize(std::max(results.size(), static_cast<std::size_t>(count)));
      std::int64_t folded = -1;
#pragma omp parallel for schedule(dynamic, 1)
      for (std::int64_t i = 0; i < count; ++i) {
        ElementValues& at = values[static_cast<std::size_t>(omp_get_thread_num())];
        evaluator.evaluate(first + i, at);
        if (at.jacobians.minCoeff() > 0) {
          compute(patch, at, results[static_cast<std::size_t>(i)]);
        } else {
#pragma omp critical
          folded = folded < 0 ? first + i : std::min(folded, first + i);
        }
      }
      if (folded >= 0) {
        evaluator.evaluate(folded, values[0]);
        require_positive_jacobian(discretization, patch, evaluator, folded, values[0]);
      }
      consume(patch, results, count);
      done += count;
      progress(phase, static_cast<double>(done) / total);
    }
  }
}

}  // namespace isopatch::iga
