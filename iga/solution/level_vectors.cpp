#include "iga/solution/level_vectors.hpp"

namespace isopatch::iga {

Eigen::VectorXd prescribed_rows(const Level& level, const Eigen::Matrix3Xd& of_globals) {
  Eigen::VectorXd result(3 * static_cast<Eigen::Index>(level.rows.local_rows()));
  for (Eigen::Index row = 0; row < level.rows.local_rows(); ++row)
    result.segment<3>(3 * row) = of_globals.col(level.rows.global_of_local()[static_cast<std::size_t>(row)]);
  return result;
}

Eigen::VectorXd free_load(const Level& level, const LevelOperator& stiffness, const Eigen::Matrix3Xd& load,
                          const Eigen::VectorXd& prescribed) {
  Eigen::VectorXd result = sum_of_nodes(level, load);  // every process has all loads: consistent
  if (level.rows.processes().largest(prescribed.isZero(0) ? 0.0 : 1.0) > 0) {
    Eigen::VectorXd forces = stiffness.forces(prescribed);
    level.rows.sum(forces);
    result -= forces;
  }
  return level.free.to_free(std::move(result));
}

Eigen::Matrix3Xd whole_at_nodes(const Level& level, const Eigen::VectorXd& of_globals) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(level.global_of.size()));
  for (Eigen::Index node = 0; node < result.cols(); ++node)
    result.col(node) =
        of_globals.segment<3>(3 * static_cast<Eigen::Index>(level.global_of[static_cast<std::size_t>(node)]));
  return result;
}

}  // namespace isopatch::iga
