#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "solvers/block_matrix.hpp"

namespace isopatch::solvers {

/// Consecutive block rows that one thread multiplies, and the last block column they reach.
struct BlockRowRange {
  int begin;
  int end;
  int last_column;
};

/// Cuts the rows into ranges of about equal work. The cut depends on the matrix alone, never on the number of
/// threads, so that sums come out the same on every machine.
std::vector<BlockRowRange> balanced_ranges(const SymmetricBlockMatrix& matrix);

/// Share of one range of rows, and of their mirror images below the diagonal, in a product. `entry` maps a
/// stored value to the one that is used, `Number` is the type in which sums are kept.
/// @return  3 (last_column + 1 - begin) values, for the rows from 3 begin on
template <class Number, class Entry>
std::vector<Number> range_product(const SymmetricBlockMatrix& matrix, const BlockRowRange& range,
                                  const Eigen::VectorXd& x, const Entry& entry) {
  std::vector<Number> y(block_size * (static_cast<std::size_t>(range.last_column) + 1 - range.begin),
                        Number(0));
  const double* const input = x.data();
  for (int row = range.begin; row < range.end; ++row) {
    const double* const x_row = input + block_size * static_cast<std::int64_t>(row);
    Number sum[block_size] = {0, 0, 0};
    for (std::int64_t k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
      const int column = matrix.columns[k];
      const double* const block = matrix.values.data() + block_entries * k;
      const double* const x_column = input + block_size * static_cast<std::int64_t>(column);
      for (int i = 0; i < block_size; ++i)
        for (int j = 0; j < block_size; ++j)
          sum[i] += static_cast<Number>(entry(block[block_size * i + j])) * x_column[j];
      if (column == row) continue;
      Number* const y_column = y.data() + block_size * static_cast<std::int64_t>(column - range.begin);
      for (int i = 0; i < block_size; ++i)
        for (int j = 0; j < block_size; ++j)
          y_column[j] += static_cast<Number>(entry(block[block_size * i + j])) * x_row[i];
    }
    for (int i = 0; i < block_size; ++i)
      y[block_size * static_cast<std::size_t>(row - range.begin) + i] += sum[i];
  }
  return y;
}

/// Product with a vector, sums kept in `Number`. The result does not depend on the number of threads.
/// @cost  one pass over the stored blocks
template <class Number, class Entry>
Eigen::Matrix<Number, Eigen::Dynamic, 1> block_product(const SymmetricBlockMatrix& matrix,
                                                       const Eigen::VectorXd& x, const Entry& entry) {
  const std::vector<BlockRowRange> ranges = balanced_ranges(matrix);
  std::vector<std::vector<Number>> parts(ranges.size());
#pragma omp parallel for schedule(dynamic, 1) if (ranges.size() > 1)
  for (std::size_t i = 0; i < ranges.size(); ++i)
    parts[i] = range_product<Number>(matrix, ranges[i], x, entry);
  Eigen::Matrix<Number, Eigen::Dynamic, 1> y(matrix.rows());
  y.setZero();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Eigen::Index first = block_size * static_cast<Eigen::Index>(ranges[i].begin);
    for (std::size_t k = 0; k < parts[i].size(); ++k) y[first + static_cast<Eigen::Index>(k)] += parts[i][k];
  }
  return y;
}

/// Product with a vector. (3 block rows)
/// @cost  one pass over the stored blocks, so about half the memory traffic of a general format
Eigen::VectorXd multiply(const SymmetricBlockMatrix& matrix, const Eigen::VectorXd& x);

}  // namespace isopatch::solvers
