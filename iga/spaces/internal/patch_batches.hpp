#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {

/// Computes planes of points of many patches and gives them to `use`, in order.
///
/// A large patch computes its planes in parallel and one at a time is in memory. Several small ones together
/// are computed at once, one a thread, because the planes of a few points are no work for several.
///
/// @param first    number of the first point of every patch, and their number at the end
/// @param compute  compute(i, take) calls take(plane, number of its first point) for every plane of patch i
/// @param use      use(plane, number of its first point)
template <class Plane, class Compute, class Use>
void for_each_plane(const std::vector<std::int64_t>& first, Compute compute, Use use) {
  constexpr std::int64_t points_of_a_batch = 30'000;
  const std::size_t count = first.size() - 1;
  for (std::size_t i = 0, end = 0; i < count; i = end) {
    end = i + 1;
    while (end < count && first[end + 1] - first[i] <= points_of_a_batch) ++end;
    if (end == i + 1) {
      compute(i, use);
      continue;
    }
    std::vector<std::vector<std::pair<Plane, std::int64_t>>> batch(end - i);
    parallel_for(static_cast<std::int64_t>(batch.size()), [&](std::int64_t b, int) {
      auto& planes = batch[static_cast<std::size_t>(b)];
      compute(i + static_cast<std::size_t>(b),
              [&](const Plane& plane, std::int64_t at) { planes.emplace_back(plane, at); });
    });
    for (const auto& planes : batch)
      for (const auto& [plane, at] : planes) use(plane, at);
  }
}

}  // namespace isopatch::iga
