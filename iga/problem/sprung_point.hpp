#pragma once

#include <Eigen/Core>
#include <string>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Springs at one place of the part: their force on it is minus the stiffness times the displacement.
struct SprungPoint {
  PatchPoint place;
  Eigen::Matrix3d stiffness;  ///< symmetric, not negative, its weight included, N/m
};

/// @param support  its name, for messages
/// @throws Error invalid_argument  a stiffness that is negative or not finite
void validate(const ElasticSupport& springs, const std::string& support);

}  // namespace isopatch::iga
