#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frame.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// The rigid motions that supports leave to a body: u(x) = t + w x (x - centre) / size, whose control points
/// move as the motion says.
struct FreeMotions {
  std::vector<PatchId> patches;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m
  double size = 0;                                   ///< of the body's box, m
  Eigen::MatrixXd motions;                           ///< (6, motions left), orthonormal columns (t, w)
};

/// (direction . u) of such motions at a place, for coordinates (t, w).
Eigen::Matrix<double, 6, 1> motion_along(const FreeMotions& body, const Eigen::Vector3d& place,
                                         const Eigen::Vector3d& direction);

/// Bodies to which frames and elastic supports leave rigid motions; those held by both are left out.
/// @param frames  one per global node
/// @cost  O(nodes)
std::vector<FreeMotions> free_motions(const ElasticityProblem& problem, const GlobalNodes& global,
                                      const std::vector<SupportFrame>& frames);

}  // namespace isopatch::iga
