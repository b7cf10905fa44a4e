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

/// A small matrix of the values of functions at points: table[point * functions + function].
struct FunctionTable {
  const double* table;
  int points;
  int functions;
};

/// An array with a constant stride.
template <class T>
struct Strided {
  T* data;
  std::ptrdiff_t step;
};

/// From functions to points, out[q][v] = sum_a table(q, a) in[a][v], or with Transposed from points to
/// functions, out[a][v] += sum_q table(q, a) in[q][v], for v below `count`. Size > 0: as many points as
/// functions, Size.
template <int Size, bool Transposed>
void contract_sized(const FunctionTable& m, Strided<const Lanes> in, Strided<Lanes> out, int count) {
  const int points = Size > 0 ? Size : m.points;
  const int functions = Size > 0 ? Size : m.functions;
  const int outer = Transposed ? functions : points;
  const int inner = Transposed ? points : functions;
  const auto entry = [&](int o, int i) {
    return m.table[Transposed ? i * functions + o : o * functions + i];
  };
  for (int v = 0; v < count; ++v) {
    const Lanes* const from = in.data + v;
    Lanes* const __restrict to = out.data + v;
    Lanes x[Size > 0 ? Size : 1];
    for (int i = 0; i < Size; ++i) x[i] = from[i * in.step];
#pragma GCC unroll 8
    for (int o = 0; o < outer; ++o) {
      Lanes total = entry(o, 0) * from[0];
      for (int i = 1; i < inner; ++i) {
        if constexpr (Size > 0)
          total += entry(o, i) * x[i];
        else
          total += entry(o, i) * from[i * in.step];
      }
      if constexpr (Transposed)
        to[o * out.step] += total;
      else
        to[o * out.step] = total;
    }
  }
}

/// contract_sized for the table at hand.
template <bool Transposed>
void contract(const FunctionTable& m, Strided<const Lanes> in, Strided<Lanes> out, int count) {
  if (m.points != m.functions) return contract_sized<0, Transposed>(m, in, out, count);
  switch (m.points) {
    case 2:
      return contract_sized<2, Transposed>(m, in, out, count);
    case 3:
      return contract_sized<3, Transposed>(m, in, out, count);
    case 4:
      return contract_sized<4, Transposed>(m, in, out, count);
    case 5:
      return contract_sized<5, Transposed>(m, in, out, count);
    case 6:
      return contract_sized<6, Transposed>(m, in, out, count);
    default:
      return contract_sized<0, Transposed>(m, in, out, count);
  }
}

}  // namespace isopatch::iga
