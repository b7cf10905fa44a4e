#pragma once

#include <vector>

namespace isopatch::verification {

/// One curved patch of steel, its basis functions as smooth as its degree allows.
struct CurvedPatch {
  int degree = 2;
  int spans = 16;         ///< knot spans per direction
  bool rational = false;  ///< a quarter of a thick cylinder; else a block with curved quadratic faces
};

/// Registers what is measured on one patch: `formation` (pattern and values of the stiffness matrix),
/// `product` (matrix times vector), `apply` (the same without a matrix). Counters: p, spans, rational,
/// omp_threads, dofs, elements, and the bytes of the matrix, or those that `apply` must read and write at
/// least.
/// @param thread_counts  of OpenMP, each measured by itself
/// @param with_matrix     whether the matrix is formed at all; else only what does without it is measured
void register_kernels(const CurvedPatch& patch, const std::vector<int>& thread_counts, bool with_matrix);

}  // namespace isopatch::verification
