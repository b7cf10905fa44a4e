#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cstdint>

#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {

/// Applies a sparse matrix along one direction of a tensor whose entries have `components` values each, first
/// direction fastest. Parallel; the result does not depend on the number of threads.
/// @param sizes  of the tensor, changed to those of the result
inline Eigen::VectorXd apply_sparse_along(const Eigen::VectorXd& values, int components,
                                          std::array<int, 3>& sizes, int direction,
                                          const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix) {
  Eigen::Index inner = components;
  Eigen::Index outer = 1;
  for (int d = 0; d < 3; ++d)
    if (d != direction) (d < direction ? inner : outer) *= sizes[static_cast<std::size_t>(d)];
  const Eigen::Index n = matrix.cols();
  const Eigen::Index m = matrix.rows();
  Eigen::VectorXd result(inner * m * outer);
  constexpr Eigen::Index piece = 4096;  // values of one task along the inner directions
  const Eigen::Index pieces = (inner + piece - 1) / piece;
  const Eigen::Index outer_per_task = std::max<Eigen::Index>(1, piece / (inner * m));
  const Eigen::Index tasks = (outer + outer_per_task - 1) / outer_per_task;
  parallel_for(tasks * pieces, [&](std::int64_t task, int) {
    const Eigen::Index begin = task % pieces * piece;
    const Eigen::Index length = std::min(piece, inner - begin);
    const Eigen::Index first = task / pieces * outer_per_task;
    for (Eigen::Index o = first; o < std::min(outer, first + outer_per_task); ++o) {
      const double* const in = values.data() + o * inner * n + begin;
      double* const out = result.data() + o * inner * m + begin;
      for (Eigen::Index r = 0; r < m; ++r) {
        Eigen::Map<Eigen::ArrayXd> target(out + r * inner, length);
        target.setZero();
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(matrix, r); it; ++it)
          target += it.value() * Eigen::Map<const Eigen::ArrayXd>(in + it.col() * inner, length);
      }
    }
  });
  sizes[static_cast<std::size_t>(direction)] = static_cast<int>(m);
  return result;
}

}  // namespace isopatch::iga
