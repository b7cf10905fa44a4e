#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/base/angle.hpp"

namespace isopatch::iga {

/// The displacements that supports leave to a global node: u = prescribed + sum over k < free of q_k
/// axes.col(k).
struct SupportFrame {
  Eigen::Matrix3d axes =
      Eigen::Matrix3d::Identity();  ///< orthonormal columns: the free directions, then the fixed ones
  int free = 3;                     ///< number of free directions
  Eigen::Vector3d prescribed = Eigen::Vector3d::Zero();  ///< m, without component along the free directions
  /// Per fixed column: the unit direction along which its support acts; the columns are these, orthogonalized
  /// from the last one down.
  std::array<Eigen::Vector3d, 3> direction = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                              Eigen::Vector3d::Zero()};
  Angle uncertainty = {};                     ///< of the directions
  std::array<int, 3> support = {-1, -1, -1};  ///< per column: the support that fixes it, or -1
};

}  // namespace isopatch::iga
