#pragma once

#include <utility>

#include "iga/internal/registers.hpp"

namespace isopatch::iga {

// Entries of two rows of a square that is transposed by exchanging halves `Step` apart.
template <int Step, int... Lane>
inline __attribute__((always_inline)) void exchange(Register& a, Register& b,
                                                    std::integer_sequence<int, Lane...>) {
  const Register first =
      __builtin_shufflevector(a, b, ((Lane & Step) != 0 ? register_size + Lane - Step : Lane)...);
  b = __builtin_shufflevector(a, b, ((Lane & Step) != 0 ? register_size + Lane : Lane + Step)...);
  a = first;
}

template <int Step>
inline __attribute__((always_inline)) void transpose_from(Register (&rows)[register_size]) {
  if constexpr (Step < register_size) {
#pragma GCC unroll 8
    for (int r = 0; r < register_size; ++r)
      if ((r & Step) == 0)
        exchange<Step>(rows[r], rows[r + Step], std::make_integer_sequence<int, register_size>{});
    transpose_from<2 * Step>(rows);
  }
}

/// Writes the columns of a square of doubles as rows.
/// @param from    rows, one register each
/// @param to      where the columns go, each `offset` further on
inline void transpose(const double* from, double* const (&to)[register_size], int offset) {
  Register rows[register_size];
#pragma GCC unroll 8
  for (int r = 0; r < register_size; ++r) rows[r] = load(from + r * register_size);
  transpose_from<1>(rows);
#pragma GCC unroll 8
  for (int r = 0; r < register_size; ++r) store(to[r] + offset, rows[r]);
}

}  // namespace isopatch::iga
