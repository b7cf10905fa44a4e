#pragma once

#include <cstddef>

namespace isopatch::iga {

/// Eight numbers that are worked on together: one quantity at eight quadrature points of a line in
/// direction 1. One register with AVX-512; the compiler splits it where registers are shorter.
using Lanes = double __attribute__((vector_size(64)));
constexpr int lane_count = 8;

inline double sum(const Lanes& v) {
  using Half = double __attribute__((vector_size(32)));
  const Half halves = __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
  return (halves[0] + halves[1]) + (halves[2] + halves[3]);
}

/// A small dense matrix inside a table: entry (o, i) lies at data[o * outer_step + i * inner_step].
struct SmallMatrix {
  const double* data;
  int outer;
  int inner;
  std::ptrdiff_t outer_step;
  std::ptrdiff_t inner_step;
};

/// Groups of vectors at equal distances.
template <class T>
struct Strided {
  T* data;
  std::ptrdiff_t step;
};

/// out[o][v] = sum_i m(o, i) in[i][v], or += with Add, for v below `count`; Inner = 0 stands for any inner
/// size.
template <int Inner, bool Add>
void contract_sized(const SmallMatrix& m, Strided<const Lanes> in, Strided<Lanes> out, int count) {
  const int inner = Inner > 0 ? Inner : m.inner;
  for (int v = 0; v < count; ++v) {
    const Lanes* const from = in.data + v;
    Lanes* const to = out.data + v;
    Lanes x[Inner > 0 ? Inner : 1];
    for (int i = 0; i < Inner; ++i) x[i] = from[i * in.step];
    for (int o = 0; o < m.outer; ++o) {
      const double* const row = m.data + o * m.outer_step;
      Lanes total{};
      if constexpr (Add) total = to[o * out.step];
      for (int i = 0; i < inner; ++i) {
        if constexpr (Inner > 0)
          total += row[i * m.inner_step] * x[i];
        else
          total += row[i * m.inner_step] * from[i * in.step];
      }
      to[o * out.step] = total;
    }
  }
}

/// contract_sized for the matrix at hand.
template <bool Add>
void contract(const SmallMatrix& m, Strided<const Lanes> in, Strided<Lanes> out, int count) {
  switch (m.inner) {
    case 2:
      return contract_sized<2, Add>(m, in, out, count);
    case 3:
      return contract_sized<3, Add>(m, in, out, count);
    case 4:
      return contract_sized<4, Add>(m, in, out, count);
    case 5:
      return contract_sized<5, Add>(m, in, out, count);
    case 6:
      return contract_sized<6, Add>(m, in, out, count);
    default:
      return contract_sized<0, Add>(m, in, out, count);
  }
}

}  // namespace isopatch::iga
