#include "solvers/block_product.hpp"

#include <algorithm>

namespace isopatch::solvers {

std::vector<BlockRowRange> balanced_ranges(const SymmetricBlockMatrix& matrix) {
  constexpr std::int64_t worth_splitting = 1 << 14;  // blocks; about 20 us of work
  constexpr int most_ranges = 16;
  const int count = matrix.blocks() < worth_splitting ? 1 : most_ranges;
  std::vector<BlockRowRange> ranges;
  int begin = 0;
  for (int i = 1; i <= count && begin < matrix.block_rows(); ++i) {
    const auto goal =
        std::lower_bound(matrix.row_start.begin(), matrix.row_start.end(), matrix.blocks() * i / count);
    const int end = static_cast<int>(goal - matrix.row_start.begin());
    if (end <= begin) continue;
    int last = begin;
    for (int row = begin; row < end; ++row)
      last = std::max(last, matrix.columns[matrix.row_start[row + 1] - 1]);
    ranges.push_back({begin, end, last});
    begin = end;
  }
  return ranges;
}

namespace {

// Three numbers and a fourth lane that is never read back: a row of a block, a node of a vector.
using Quad = double __attribute__((vector_size(32)));
using UnalignedQuad = double __attribute__((vector_size(32), aligned(8), may_alias));

// Share of one range of rows, and of their mirror images below the diagonal, four numbers a node. Every row
// of a block is one vector; its fourth lane, the first entry of the next row, meets the zero that pads x, or
// goes where nobody reads.
std::vector<Quad> quad_product(const SymmetricBlockMatrix& matrix, const BlockRowRange& range,
                               const std::vector<Quad>& x) {
  std::vector<Quad> y(static_cast<std::size_t>(range.last_column) + 1 -
                      static_cast<std::size_t>(range.begin));
  Quad* const shifted = y.data() - range.begin;
  const auto row_of = [](const double* from) { return *reinterpret_cast<const UnalignedQuad*>(from); };
  const std::int64_t last = matrix.blocks() - 1;
  for (int row = range.begin; row < range.end; ++row) {
    const Quad x_row = x[static_cast<std::size_t>(row)];
    Quad sums[block_size] = {};
    for (std::int64_t k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
      const double* const block = matrix.values.data() + block_entries * k;
      const int column = matrix.columns[k];
      const Quad first = row_of(block), second = row_of(block + block_size);
      const Quad third = k < last ? Quad(row_of(block + 6)) : Quad{block[6], block[7], block[8], 0};
      const Quad x_column = x[static_cast<std::size_t>(column)];
      sums[0] += first * x_column;
      sums[1] += second * x_column;
      sums[2] += third * x_column;
      if (column != row)  // the first one is the diagonal block
        shifted[column] += x_row[0] * first + x_row[1] * second + x_row[2] * third;
    }
    for (int i = 0; i < block_size; ++i) shifted[row][i] += sums[i][0] + sums[i][1] + sums[i][2];
  }
  return y;
}

}  // namespace

Eigen::VectorXd multiply(const SymmetricBlockMatrix& matrix, const Eigen::VectorXd& x) {
  const std::vector<BlockRowRange> ranges = balanced_ranges(matrix);
  const auto rows = static_cast<std::size_t>(matrix.block_rows());
  std::vector<Quad> padded(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const Eigen::Index at = block_size * static_cast<Eigen::Index>(row);
    padded[row] = Quad{x[at], x[at + 1], x[at + 2], 0};
  }
  std::vector<std::vector<Quad>> parts(ranges.size());
#pragma omp parallel for schedule(dynamic, 1) if (ranges.size() > 1)
  for (std::size_t i = 0; i < ranges.size(); ++i) parts[i] = quad_product(matrix, ranges[i], padded);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(matrix.rows());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Eigen::Index first = block_size * static_cast<Eigen::Index>(ranges[i].begin);
    for (std::size_t k = 0; k < parts[i].size(); ++k)
      for (int c = 0; c < block_size; ++c)
        y[first + block_size * static_cast<Eigen::Index>(k) + c] += parts[i][k][c];
  }
  return y;
}

}  // namespace isopatch::solvers
