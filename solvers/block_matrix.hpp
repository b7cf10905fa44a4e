#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "solvers/block_size.hpp"
#include "solvers/zeroed_allocator.hpp"

namespace isopatch::solvers {

/// Symmetric sparse matrix of 3x3 blocks; only the blocks on and above the diagonal are stored.
///
/// Row r holds its blocks at positions row_start[r] .. row_start[r + 1], columns increasing, the first one
/// the diagonal block (column r), which is always present and symmetric.
struct SymmetricBlockMatrix {
  std::vector<std::int64_t> row_start = {0};
  ZeroedVector<int> columns;
  ZeroedVector<double> values;  ///< `block_entries` per block, row by row

  /// Number of block rows.
  int block_rows() const { return static_cast<int>(row_start.size()) - 1; }
  /// Number of scalar rows.
  int rows() const { return block_size * block_rows(); }
  std::int64_t blocks() const { return static_cast<std::int64_t>(columns.size()); }
  /// Scalar entries of the whole matrix, both triangles.
  std::int64_t nonzeros() const { return block_entries * (2 * blocks() - block_rows()); }
  std::int64_t bytes() const;
};

/// Mean of the absolute diagonal entries.
double mean_diagonal(const SymmetricBlockMatrix& matrix);

}  // namespace isopatch::solvers
