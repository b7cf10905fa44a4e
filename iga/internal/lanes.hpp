#pragma once

#include <cstddef>
#include <type_traits>

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
/// functions, out[a][v] += sum_q table(q, a) in[q][v], for v below `count`. Points, Functions > 0: so many.
template <int Points, int Functions, bool Transposed>
void contract_sized(const FunctionTable& m, Strided<const Lanes> in, Strided<Lanes> out, int count) {
  constexpr int Inner = Transposed ? Points : Functions;
  const int points = Points > 0 ? Points : m.points;
  const int functions = Functions > 0 ? Functions : m.functions;
  const int outer = Transposed ? functions : points;
  const int inner = Transposed ? points : functions;
  const auto entry = [&](int o, int i) {
    return m.table[Transposed ? i * functions + o : o * functions + i];
  };
  for (int v = 0; v < count; ++v) {
    const Lanes* const from = in.data + v;
    Lanes* const __restrict to = out.data + v;
    Lanes x[Inner > 0 ? Inner : 1];
    for (int i = 0; i < Inner; ++i) x[i] = from[i * in.step];
#pragma GCC unroll 8
    for (int o = 0; o < outer; ++o) {
      Lanes total = entry(o, 0) * from[0];
      for (int i = 1; i < inner; ++i) {
        if constexpr (Inner > 0)
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

/// contract_sized for the table at hand: as many points as functions, or one less or more.
template <bool Transposed>
void contract(const FunctionTable& m, Strided<const Lanes> in, Strided<Lanes> out, int count) {
  const auto sized = [&]<int Functions>(std::integral_constant<int, Functions>) {
    if (m.points == Functions) return contract_sized<Functions, Functions, Transposed>(m, in, out, count);
    if (m.points == Functions - 1)
      return contract_sized<Functions - 1, Functions, Transposed>(m, in, out, count);
    if (m.points == Functions + 1)
      return contract_sized<Functions + 1, Functions, Transposed>(m, in, out, count);
    contract_sized<0, 0, Transposed>(m, in, out, count);
  };
  switch (m.functions) {
    case 2:
      return sized(std::integral_constant<int, 2>());
    case 3:
      return sized(std::integral_constant<int, 3>());
    case 4:
      return sized(std::integral_constant<int, 4>());
    case 5:
      return sized(std::integral_constant<int, 5>());
    case 6:
      return sized(std::integral_constant<int, 6>());
    default:
      return contract_sized<0, 0, Transposed>(m, in, out, count);
  }
}

}  // namespace isopatch::iga
