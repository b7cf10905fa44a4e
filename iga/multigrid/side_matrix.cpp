#include "iga/multigrid/side_matrix.hpp"

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/assembly/face_stiffness.hpp"
#include "iga/coupling/supported_system.hpp"
#include "solvers/cholmod_solver.hpp"

namespace isopatch::iga {
namespace {

// A matrix of so many rows with blocks on the diagonal alone, all 0.
solvers::SymmetricBlockMatrix diagonal_blocks(int rows) {
  solvers::SymmetricBlockMatrix result;
  result.columns.resize(static_cast<std::size_t>(rows));
  result.values.resize(9 * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    result.columns[static_cast<std::size_t>(row)] = row;
    result.row_start.push_back(row + 1);
  }
  return result;
}

}  // namespace

std::vector<int> rows_on(const Level& level, const SidesOfPatches& sides) {
  std::vector<int> rows;
  for (const auto& [patch, of_patch] : sides) {
    const auto p = static_cast<std::size_t>(patch.value);
    for (const geometry::Side side : of_patch)
      for (const int node : geometry::face_control_points(level.spaces[p].sizes(), side))
        rows.push_back(level.row_of_node[static_cast<std::size_t>(level.first_node[p] + node)]);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

solvers::SymmetricBlockMatrix side_matrix(const Level& level, const SidesOfPatches& sides,
                                          const std::vector<int>& rows,
                                          const std::vector<Material>& materials, const NodeBlocks& surfaces,
                                          const std::vector<Eigen::Matrix3d>& diagonal) {
  // Nodes elsewhere that share a row of the block belong to it too.
  std::vector<int> of_row(static_cast<std::size_t>(level.rows.local_rows()), -1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    of_row[static_cast<std::size_t>(rows[i])] = static_cast<int>(i);
  RowNumbering numbering{{}, static_cast<int>(rows.size())};
  for (const int row : level.row_of_node)
    numbering.row_of_node.push_back(row < 0 ? -1 : of_row[static_cast<std::size_t>(row)]);
  solvers::SymmetricBlockMatrix matrix = diagonal_blocks(numbering.rows);
  NodeBlocks all = surfaces;
  for (const auto& [patch, of_patch] : sides) {
    const auto p = static_cast<std::size_t>(patch.value);
    all.add(face_stiffness(level.spaces[p], of_patch, level.first_node[p], materials[p]));
  }
  all.add_to(matrix, numbering);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> block(
        &matrix.values[static_cast<std::size_t>(9 * matrix.row_start[i])]);
    block = diagonal[static_cast<std::size_t>(rows[i])];
  }
  const std::vector<SupportFrame> frames = level.free.frames(level.rows.local_rows());
  std::vector<const SupportFrame*> of_rows;
  for (const int row : rows) of_rows.push_back(&frames[static_cast<std::size_t>(row)]);
  std::vector<LoadOfRows> no_loads;
  apply_supports(matrix, solvers::SharedRows(numbering.rows), of_rows, no_loads);
  return matrix;
}

solvers::LinearOperator inverse_for_smoothing(const solvers::SymmetricBlockMatrix& matrix) {
  for (double more = 0;; more = more == 0 ? 0.1 : 10 * more) {
    solvers::SymmetricBlockMatrix heavier = matrix;
    for (int row = 0; row < matrix.block_rows(); ++row)
      for (std::int64_t k = 0; k < 9; ++k)
        heavier.values[static_cast<std::size_t>(9 * matrix.row_start[static_cast<std::size_t>(row)] + k)] *=
            1 + more;
    try {
      return solvers::cholmod_inverse(std::move(heavier));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::singular_system || more > 50) throw;
    }
  }
}

void add_to_rows(const std::vector<int>& rows, const solvers::LinearOperator& inverse,
                 const Eigen::VectorXd& residual, Eigen::VectorXd& result) {
  Eigen::VectorXd here(3 * static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    here.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        residual.segment<3>(3 * static_cast<Eigen::Index>(rows[i]));
  here = inverse(here);
  for (std::size_t i = 0; i < rows.size(); ++i)
    result.segment<3>(3 * static_cast<Eigen::Index>(rows[i])) +=
        here.segment<3>(3 * static_cast<Eigen::Index>(i));
}

}  // namespace isopatch::iga
