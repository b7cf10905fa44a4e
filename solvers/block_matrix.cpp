#include "solvers/block_matrix.hpp"

#include <cmath>

namespace isopatch::solvers {

std::int64_t SymmetricBlockMatrix::bytes() const {
  return static_cast<std::int64_t>(row_start.size() * sizeof(std::int64_t) + columns.size() * sizeof(int) +
                                   values.size() * sizeof(double));
}

double mean_diagonal(const SymmetricBlockMatrix& matrix) {
  double sum = 0;
  for (int row = 0; row < matrix.block_rows(); ++row)
    for (int i = 0; i < block_size; ++i)
      sum += std::abs(matrix.values[block_entries * matrix.row_start[row] + (block_size + 1) * i]);
  return matrix.rows() == 0 ? 0 : sum / matrix.rows();
}

}  // namespace isopatch::solvers
