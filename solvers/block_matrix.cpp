#include "solvers/block_matrix.hpp"

#include <cmath>

#include "solvers/block_product.hpp"

namespace isopatch::solvers {

std::int64_t SymmetricBlockMatrix::bytes() const {
  return static_cast<std::int64_t>(row_start.size() * sizeof(std::int64_t) + columns.size() * sizeof(int) +
                                   values.size() * sizeof(double));
}

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

Eigen::VectorXd multiply(const SymmetricBlockMatrix& matrix, const Eigen::VectorXd& x) {
  return block_product<double>(matrix, x, [](double value) { return value; });
}

double mean_diagonal(const SymmetricBlockMatrix& matrix) {
  double sum = 0;
  for (int row = 0; row < matrix.block_rows(); ++row)
    for (int i = 0; i < 3; ++i) sum += std::abs(matrix.values[9 * matrix.row_start[row] + 4 * i]);
  return matrix.rows() == 0 ? 0 : sum / matrix.rows();
}

}  // namespace isopatch::solvers
