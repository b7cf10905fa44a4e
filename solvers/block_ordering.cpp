#include "solvers/block_ordering.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "solvers/internal/cholmod_api.hpp"

namespace isopatch::solvers {
namespace {

void try_metis_then_amd(CholmodWorkspace<std::int32_t>& workspace) {
  workspace->nmethods = 2;
  workspace->method[0].ordering = CHOLMOD_METIS;
  workspace->method[1].ordering = CHOLMOD_AMD;
  workspace->postorder = true;
  workspace->supernodal = CHOLMOD_SIMPLICIAL;
}

}  // namespace

BlockOrdering fill_reducing_ordering(const SymmetricBlockMatrix& matrix) {
  if (matrix.blocks() > std::numeric_limits<int>::max())
    throw Error(
        ErrorCode::unsupported,
        fmt::format("the matrix has {} blocks, more than the {} that orderings can count; use method 'cg'",
                    matrix.blocks(), std::numeric_limits<int>::max()));
  // Rows of the upper triangle are columns of the lower one.
  std::vector<int> column_start(matrix.row_start.begin(), matrix.row_start.end());
  CholmodWorkspace<std::int32_t> workspace;
  try_metis_then_amd(workspace);
  cholmod_sparse graph =
      lower_triangle_view<std::int32_t>(static_cast<std::size_t>(matrix.block_rows()), column_start.data(),
                                        const_cast<int*>(matrix.columns.data()), nullptr, true);
  const CholmodFactor<std::int32_t> factor(cholmod_analyze(&graph, workspace.get()), workspace);
  if (!factor.get())
    throw Error(
        workspace->status == CHOLMOD_OUT_OF_MEMORY ? ErrorCode::out_of_memory : ErrorCode::internal,
        fmt::format("ordering {} block rows with {} blocks failed (CHOLMOD status {}) after {} bytes",
                    matrix.block_rows(), matrix.blocks(), workspace->status, workspace->memory_usage));
  const auto* const permutation = static_cast<const int*>(factor->Perm);
  BlockOrdering ordering{{permutation, permutation + matrix.block_rows()},
                         std::vector<int>(matrix.block_rows())};
  for (int k = 0; k < matrix.block_rows(); ++k) ordering.position[ordering.order[k]] = k;
  return ordering;
}

}  // namespace isopatch::solvers
