#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/discretization.hpp"
#include "iga/element.hpp"
#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {

/// @throws Error fold_over for a point of an element with det J <= 0, naming patch, parameter and place
void require_positive_jacobian(const Discretization& discretization, int patch,
                               const ElementEvaluator& evaluator, std::int64_t element,
                               const ElementValues& values);

/// One element of a discretization.
struct ElementAt {
  int patch = 0;
  std::int64_t element = 0;  ///< within the patch
};

/// Walks over all elements of all patches in batches: each batch is computed in parallel, then consumed.
///
/// @param compute  (ElementAt, const ElementValues&, Scratch&, Result&): called in parallel; one Scratch a
/// thread
/// @param consume  (std::span<const Result>): called by one thread, in the order of the elements, so that
/// what it
///                 sums does not depend on the number of threads
/// @param result_bytes  what one Result holds: a batch stays below 64 MB, but has two elements a thread
template <class Scratch, class Result, class Compute, class Consume>
void for_each_element(const Discretization& discretization, int points, std::int64_t result_bytes,
                      const Progress& progress, const char* phase, Compute compute, Consume consume) {
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  std::vector<ElementEvaluator> evaluators;
  std::vector<std::int64_t> first = {0};
  for (const geometry::NurbsVolume& patch : discretization.patches) {
    evaluators.emplace_back(patch, points);
    first.push_back(first.back() + evaluators.back().element_count());
  }
  const std::int64_t batch =
      std::max<std::int64_t>(2 * static_cast<std::int64_t>(threads), (std::int64_t{64} << 20) / result_bytes);
  std::vector<Result> results(static_cast<std::size_t>(std::min(batch, first.back())));
  std::vector<Scratch> scratch(threads);
  std::vector<ElementValues> values(threads);
  for (std::int64_t start = 0; start < first.back(); start += batch) {
    const std::int64_t count = std::min(batch, first.back() - start);
    parallel_for(count, [&](std::int64_t i, int thread) {
      const auto patch = std::upper_bound(first.begin(), first.end(), start + i) - first.begin() - 1;
      const ElementAt at{static_cast<int>(patch), start + i - first[static_cast<std::size_t>(patch)]};
      ElementValues& here = values[static_cast<std::size_t>(thread)];
      const ElementEvaluator& evaluator = evaluators[static_cast<std::size_t>(patch)];
      evaluator.evaluate(at.element, here);
      require_positive_jacobian(discretization, at.patch, evaluator, at.element, here);
      compute(at, here, scratch[static_cast<std::size_t>(thread)], results[static_cast<std::size_t>(i)]);
    });
    consume(std::span<const Result>(results.data(), static_cast<std::size_t>(count)));
    progress(phase, static_cast<double>(start + count) / static_cast<double>(first.back()));
  }
}

}  // namespace isopatch::iga
