#include "iga/multigrid/level_operator.hpp"

namespace isopatch::iga {

Eigen::VectorXd sum_of_nodes(const Level& level, const Eigen::Matrix3Xd& of_nodes) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(level.rows.local_rows()));
  for (Eigen::Index node = 0; node < of_nodes.cols(); ++node) {
    const int row = level.row_of_node[static_cast<std::size_t>(node)];
    if (row >= 0) sum.segment<3>(3 * static_cast<Eigen::Index>(row)) += of_nodes.col(node);
  }
  return sum;
}

Eigen::Matrix3Xd at_nodes(const Level& level, const Eigen::VectorXd& of_rows) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(level.row_of_node.size()));
#pragma omp parallel for schedule(static) if (result.cols() > 10000)
  for (Eigen::Index node = 0; node < result.cols(); ++node) {
    const int row = level.row_of_node[static_cast<std::size_t>(node)];
    if (row >= 0)
      result.col(node) = of_rows.segment<3>(3 * static_cast<Eigen::Index>(row));
    else
      result.col(node).setZero();
  }
  return result;
}

LevelOperator::LevelOperator(const Level& level, const std::vector<Material>& materials, int points,
                             const SurfaceTerms& surfaces)
    : LevelOperator(level, level.spaces, materials, points, surfaces) {}

LevelOperator::LevelOperator(const Level& level, const std::vector<PatchSpace>& spaces,
                             const std::vector<Material>& materials, int points, const SurfaceTerms& surfaces)
    : level_(&level),
      stiffness_(spaces, level.parts, materials, points),
      surfaces_(surface_stiffness(spaces, level.parts, surfaces)) {}

Eigen::VectorXd LevelOperator::forces(const Eigen::VectorXd& displacement) const {
  const Eigen::Matrix3Xd of_nodes = at_nodes(*level_, displacement);
  Eigen::Matrix3Xd forces = stiffness_.apply(of_nodes);
  surfaces_.add_forces(of_nodes, forces);
  return sum_of_nodes(*level_, forces);
}

Eigen::VectorXd LevelOperator::apply(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = forces(level_->free.to_space(x));
  level_->rows.sum(result);
  return level_->free.to_free(std::move(result));
}

Eigen::MatrixXd LevelOperator::forces_each(const Eigen::MatrixXd& displacements) const {
  std::vector<Eigen::Matrix3Xd> of_nodes;
  for (Eigen::Index i = 0; i < displacements.cols(); ++i)
    of_nodes.push_back(at_nodes(*level_, displacements.col(i)));
  std::vector<Eigen::Matrix3Xd> forces = stiffness_.apply(of_nodes);
  Eigen::MatrixXd result(displacements.rows(), displacements.cols());
  for (Eigen::Index i = 0; i < displacements.cols(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    surfaces_.add_forces(of_nodes[k], forces[k]);
    result.col(i) = sum_of_nodes(*level_, forces[k]);
  }
  return result;
}

Eigen::MatrixXd LevelOperator::apply_each(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd displacements(x.rows(), x.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i) displacements.col(i) = level_->free.to_space(x.col(i));
  Eigen::MatrixXd result = forces_each(displacements);
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    Eigen::VectorXd sum = result.col(i);
    level_->rows.sum(sum);
    result.col(i) = level_->free.to_free(std::move(sum));
  }
  return result;
}

std::vector<Eigen::Matrix3d> LevelOperator::diagonal() const {
  std::vector<Eigen::Matrix3d> of_nodes = stiffness_.diagonal_blocks();
  surfaces_.add_diagonal(of_nodes);
  const auto rows = static_cast<std::size_t>(level_->rows.local_rows());
  std::vector<Eigen::Matrix3d> result(rows, Eigen::Matrix3d::Zero());
  for (std::size_t node = 0; node < of_nodes.size(); ++node)
    if (level_->row_of_node[node] >= 0)
      result[static_cast<std::size_t>(level_->row_of_node[node])] += of_nodes[node];
  if (!level_->rows.is_distributed()) return result;
  for (int column = 0; column < 3; ++column) {
    Eigen::VectorXd values(3 * static_cast<Eigen::Index>(rows));
    for (std::size_t row = 0; row < rows; ++row)
      values.segment<3>(3 * static_cast<Eigen::Index>(row)) = result[row].col(column);
    level_->rows.sum(values);
    for (std::size_t row = 0; row < rows; ++row)
      result[row].col(column) = values.segment<3>(3 * static_cast<Eigen::Index>(row));
  }
  return result;
}

}  // namespace isopatch::iga
