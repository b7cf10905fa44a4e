#pragma once

#include <utility>

#include "iga/internal/native_lanes.hpp"

namespace isopatch::iga {

// Entries of two rows of a square that is transposed by exchanging halves `Step` apart.
template <int Step, int... Lane>
inline __attribute__((always_inline)) void exchange(NativeLanes& a, NativeLanes& b,
                                                    std::integer_sequence<int, Lane...>) {
  const NativeLanes first =
      __builtin_shufflevector(a, b, ((Lane & Step) != 0 ? native_lane_count + Lane - Step : Lane)...);
  b = __builtin_shufflevector(a, b, ((Lane & Step) != 0 ? native_lane_count + Lane : Lane + Step)...);
  a = first;
}

template <int Step>
inline __attribute__((always_inline)) void transpose_from(NativeLanes (&rows)[native_lane_count]) {
  if constexpr (Step < native_lane_count) {
#pragma GCC unroll 8
    for (int r = 0; r < native_lane_count; ++r)
      if ((r & Step) == 0)
        exchange<Step>(rows[r], rows[r + Step], std::make_integer_sequence<int, native_lane_count>{});
    transpose_from<2 * Step>(rows);
  }
}

/// Writes the columns of a square of doubles as rows.
/// @param from    rows, one register each
/// @param to      where the columns go, each `offset` further on
inline void transpose(const double* from, double* const (&to)[native_lane_count], int offset) {
  NativeLanes rows[native_lane_count];
#pragma GCC unroll 8
  for (int r = 0; r < native_lane_count; ++r) rows[r] = load(from + r * native_lane_count);
  transpose_from<1>(rows);
#pragma GCC unroll 8
  for (int r = 0; r < native_lane_count; ++r) store(to[r] + offset, rows[r]);
}

}  // namespace isopatch::iga
