#include "solvers/linear_system.hpp"

namespace isopatch::solvers {

double mean_diagonal(const SymmetricBlockMatrix& stiffness, const SharedRows& rows) {
  if (!rows.is_distributed()) return mean_diagonal(stiffness);
  Eigen::VectorXd diagonal(stiffness.rows());
  for (int row = 0; row < stiffness.block_rows(); ++row)
    for (int i = 0; i < block_size; ++i)
      diagonal[block_size * row + i] =
          stiffness.values[block_entries * stiffness.row_start[row] + (block_size + 1) * i];
  rows.sum(diagonal);
  const double sum = rows.dot(diagonal.cwiseAbs(), Eigen::VectorXd::Ones(diagonal.size()));
  return rows.global_rows() == 0 ? 0 : sum / (static_cast<double>(block_size) * rows.global_rows());
}

}  // namespace isopatch::solvers
