#pragma once

#include <Eigen/Core>

#include "iga/multigrid/level.hpp"
#include "iga/multigrid/level_operator.hpp"

namespace isopatch::iga {

/// What supports prescribe, from global nodes to the local rows of a level. (3 rows), m
Eigen::VectorXd prescribed_rows(const Level& level, const Eigen::Matrix3Xd& of_globals);

/// Forces that the loads, and the prescribed displacements, put on the unknowns of a level. (3 rows), N
/// @param load        (3, nodes of all patches), the same on every process
/// @param prescribed  from `prescribed_rows`
Eigen::VectorXd free_load(const Level& level, const LevelOperator& stiffness, const Eigen::Matrix3Xd& load,
                          const Eigen::VectorXd& prescribed);

/// The values of all rows of the whole system at all nodes of all patches. (3, nodes)
Eigen::Matrix3Xd whole_at_nodes(const Level& level, const Eigen::VectorXd& of_globals);

}  // namespace isopatch::iga
