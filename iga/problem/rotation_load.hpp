#pragma once

#include <string>
#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// A steady rotation about an axis.
struct Rotation {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the axis, m
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of any length
  double speed = 0;                                 ///< rad/s
  bool operator==(const Rotation&) const = default;
};

/// The centrifugal force of patches that rotate, density speed^2 r outwards from the axis; one load per
/// patch, because densities differ.
/// @throws Error invalid_argument if a patch's material has no density, or the axis no direction
std::vector<VolumeLoad> rotation_load(const std::string& name, const std::vector<PatchId>& patches,
                                      const Rotation& rotation, const std::vector<Material>& materials);

}  // namespace isopatch::iga
