#include "iga/multigrid/interface_block.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/assembly/face_stiffness.hpp"
#include "iga/coupling/supported_system.hpp"
#include "solvers/cholmod_solver.hpp"

namespace isopatch::iga {
namespace {

// By patch.
std::map<PatchId, std::vector<geometry::Side>> sides_that_do_not_match(
    const geometry::MultiPatch& model, const std::vector<PatchLayers>& parts) {
  std::map<PatchId, std::vector<geometry::Side>> result;
  const auto is_here = [&](const PatchLayers& part, PatchId patch) {
    return part.couples && part.patch == patch.value;
  };
  const auto add = [&](const geometry::PatchFace& face) {
    if (std::none_of(parts.begin(), parts.end(),
                     [&](const PatchLayers& part) { return is_here(part, face.patch); }))
      return;
    std::vector<geometry::Side>& sides = result[face.patch];
    if (std::find(sides.begin(), sides.end(), face.side) == sides.end()) sides.push_back(face.side);
  };
  for (const geometry::NonMatchingInterface& interface : model.non_matching()) {
    add(interface.first);
    add(interface.second);
  }
  return result;
}

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

// The inverse, with a heavier diagonal where on coarse and strongly curved elements integration leaves the
// matrix indefinite: a smoother need not be exact.
solvers::LinearOperator inverse_of(const solvers::SymmetricBlockMatrix& matrix) {
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

}  // namespace

std::vector<bool> nodes_that_do_not_match(const geometry::MultiPatch& model, const Level& level) {
  std::vector<bool> result(level.global_of.size(), false);
  for (const auto& [patch, sides] : sides_that_do_not_match(model, whole_patches(level.spaces))) {
    const auto p = static_cast<std::size_t>(patch.value);
    for (const geometry::Side side : sides)
      for (const int node : geometry::face_control_points(level.spaces[p].sizes(), side))
        result[static_cast<std::size_t>(level.first_node[p] + node)] = true;
  }
  return result;
}

InterfaceMatrix interface_matrix(const geometry::MultiPatch& model, const Level& level,
                                 const std::vector<Material>& materials, const NodeBlocks& surfaces,
                                 const std::vector<Eigen::Matrix3d>& diagonal) {
  if (model.non_matching().empty()) return {};
  // Rows of the block; nodes elsewhere that share one belong to it too.
  std::vector<int> of_row(static_cast<std::size_t>(level.rows.local_rows()), -1);
  const auto sides_here = sides_that_do_not_match(model, level.parts);
  std::vector<int> rows;
  for (const auto& [patch, sides] : sides_here) {
    const auto p = static_cast<std::size_t>(patch.value);
    for (const geometry::Side side : sides)
      for (const int node : geometry::face_control_points(level.spaces[p].sizes(), side))
        rows.push_back(level.row_of_node[static_cast<std::size_t>(level.first_node[p] + node)]);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  if (rows.empty()) return {};
  for (std::size_t i = 0; i < rows.size(); ++i)
    of_row[static_cast<std::size_t>(rows[i])] = static_cast<int>(i);
  RowNumbering numbering{{}, static_cast<int>(rows.size())};
  for (const int row : level.row_of_node)
    numbering.row_of_node.push_back(row < 0 ? -1 : of_row[static_cast<std::size_t>(row)]);
  solvers::SymmetricBlockMatrix matrix = diagonal_blocks(numbering.rows);
  NodeBlocks all = surfaces;
  for (const auto& [patch, sides] : sides_here) {
    const auto p = static_cast<std::size_t>(patch.value);
    all.add(face_stiffness(level.spaces[p], sides, level.first_node[p], materials[p]));
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
  return {std::move(rows), std::move(matrix)};
}

InterfaceBlock::InterfaceBlock(const geometry::MultiPatch& model, const Level& level,
                               const std::vector<Material>& materials, const NodeBlocks& surfaces,
                               const std::vector<Eigen::Matrix3d>& diagonal) {
  InterfaceMatrix of_faces = interface_matrix(model, level, materials, surfaces, diagonal);
  if (of_faces.rows.empty()) return;
  rows_ = std::move(of_faces.rows);
  inverse_ = inverse_of(of_faces.matrix);
}

void InterfaceBlock::add(const Eigen::VectorXd& residual, Eigen::VectorXd& result) const {
  if (rows_.empty()) return;
  Eigen::VectorXd here(3 * static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    here.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        residual.segment<3>(3 * static_cast<Eigen::Index>(rows_[i]));
  here = inverse_(here);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    result.segment<3>(3 * static_cast<Eigen::Index>(rows_[i])) +=
        here.segment<3>(3 * static_cast<Eigen::Index>(i));
}

}  // namespace isopatch::iga
