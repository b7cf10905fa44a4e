#include "iga/internal/small_products.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "iga/internal/native_lanes.hpp"

namespace isopatch::iga {
namespace {

constexpr int max_sums = 24;      // registers of sums in one block
constexpr int max_registers = 6;  // per row of a block

// A block's part of the operands.
struct BlockOperands {
  const double* factors;
  std::ptrdiff_t factor_step;
  const int* offsets;
  int terms;
  const double* rows;
  double* out;
  std::ptrdiff_t out_step;
};

// M rows of T registers, all sums in registers.
template <bool Add, int M, int T>
void block_product(const BlockOperands& b) {
  NativeLanes sums[M][T] = {};
  const double* factor = b.factors;
  for (int k = 0; k < b.terms; ++k, factor += b.factor_step) {
    const double* const row = b.rows + b.offsets[k];
    NativeLanes values[T];
#pragma GCC unroll 6
    for (int t = 0; t < T; ++t) values[t] = load(row + t * native_lane_count);
#pragma GCC unroll 12
    for (int m = 0; m < M; ++m) {
      const NativeLanes f = factor[m] - NativeLanes{};
#pragma GCC unroll 6
      for (int t = 0; t < T; ++t) sums[m][t] += f * values[t];
    }
  }
#pragma GCC unroll 12
  for (int m = 0; m < M; ++m)
#pragma GCC unroll 6
    for (int t = 0; t < T; ++t) {
      double* const to = b.out + m * b.out_step + t * native_lane_count;
      store(to, Add ? load(to) + sums[m][t] : sums[m][t]);
    }
}

using Kernel = void (*)(const BlockOperands&);
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
constexpr auto kernels = all_kernels<Add>(std::make_integer_sequence<int, max_registers>{});

template <bool Add, class Block>
void product(const std::vector<Block>& blocks, const SmallProducts::Operands& o, int outputs) {
  for (const Block& block : blocks)
    kernels<Add>[static_cast<std::size_t>(block.width - 1)][static_cast<std::size_t>(block.height - 1)](
        {o.factors + block.first_output, outputs, o.offsets, o.terms, o.rows + block.first_column,
         o.out + block.first_output * o.out_step + block.first_column, o.out_step});
}

// Size of part i of `count` nearly equal parts of a whole.
int share(int whole, int i, int count) {
  return whole * (i + 1) / count - whole * i / count;
}

}  // namespace

SmallProducts::SmallProducts(int outputs, int columns) : outputs_(outputs), columns_(columns) {
  const int registers = padded(columns) / native_lane_count;
  const int strips = (registers + max_registers - 1) / max_registers;
  for (int strip = 0, column = 0; strip < strips; ++strip) {
    const int width = share(registers, strip, strips);
    const int heights = (outputs + most_outputs(width) - 1) / most_outputs(width);
    for (int i = 0, output = 0; i < heights; ++i) {
      const int height = share(outputs, i, heights);
      blocks_.push_back({height, width, output, column});
      output += height;
    }
    column += width * native_lane_count;
  }
}

void SmallProducts::multiply(const Operands& operands) const {
  product<false>(blocks_, operands, outputs_);
}

void SmallProducts::multiply_add(const Operands& operands) const {
  product<true>(blocks_, operands, outputs_);
}

}  // namespace isopatch::iga
