#include "iga/internal/small_products.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "iga/internal/registers.hpp"

namespace isopatch::iga {
namespace {

constexpr int max_sums = 24;      // registers of sums in one block
constexpr int max_registers = 6;  // per row of a block

struct Block {
  const double* factors;
  int factor_step;
  const int* offsets;
  int terms;
  const double* rows;
  double* out;
  int out_step;
};

// M rows of T registers, all sums in registers.
template <bool Add, int M, int T>
void block_product(const Block& b) {
  Register sums[M][T] = {};
  const double* factor = b.factors;
  for (int k = 0; k < b.terms; ++k, factor += b.factor_step) {
    const double* const row = b.rows + b.offsets[k];
    Register values[T];
#pragma GCC unroll 6
    for (int t = 0; t < T; ++t) values[t] = load(row + t * register_size);
#pragma GCC unroll 12
    for (int m = 0; m < M; ++m) {
      const Register f = factor[m] - Register{};
#pragma GCC unroll 6
      for (int t = 0; t < T; ++t) sums[m][t] += f * values[t];
    }
  }
#pragma GCC unroll 12
  for (int m = 0; m < M; ++m)
#pragma GCC unroll 6
    for (int t = 0; t < T; ++t) {
      double* const to = b.out + m * b.out_step + t * register_size;
      store(to, Add ? load(to) + sums[m][t] : sums[m][t]);
    }
}

using Kernel = void (*)(const Block&);
constexpr int max_outputs = 12;

constexpr int most_outputs(int registers) {
  return std::min(max_outputs, max_sums / registers);
}

template <bool Add, int T, int... M>
constexpr std::array<Kernel, max_outputs> kernels_of(std::integer_sequence<int, M...>) {
  return {&block_product<Add, std::min(M + 1, most_outputs(T)), T>...};
}

template <bool Add, int... T>
constexpr std::array<std::array<Kernel, max_outputs>, max_registers> all_kernels(
    std::integer_sequence<int, T...>) {
  return {kernels_of<Add, T + 1>(std::make_integer_sequence<int, max_outputs>{})...};
}

template <bool Add>
void product(const SmallProduct& p, const double* rows, double* out, int out_step) {
  static constexpr auto kernels = all_kernels<Add>(std::make_integer_sequence<int, max_registers>{});
  const int registers = padded(p.columns) / register_size;
  const int strips = (registers + max_registers - 1) / max_registers;
  for (int strip = 0, done = 0; strip < strips; ++strip) {
    const int width = (registers - done + strips - strip - 1) / (strips - strip);
    const int most = most_outputs(width);
    const int blocks = (p.outputs + most - 1) / most;
    for (int block = 0, first = 0; block < blocks; ++block) {
      const int height = (p.outputs - first + blocks - block - 1) / (blocks - block);
      const int column = done * register_size;
      kernels[static_cast<std::size_t>(width - 1)][static_cast<std::size_t>(height - 1)](
          {p.factors + first, p.factor_step, p.offsets, p.terms, rows + column,
           out + first * out_step + column, out_step});
      first += height;
    }
    done += width;
  }
}

}  // namespace

void multiply(const SmallProduct& p, const double* rows, double* out, int out_step) {
  product<false>(p, rows, out, out_step);
}

void multiply_add(const SmallProduct& p, const double* rows, double* out, int out_step) {
  product<true>(p, rows, out, out_step);
}

}  // namespace isopatch::iga
