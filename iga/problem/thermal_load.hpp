#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "iga/material/material.hpp"
#include "iga/material/thermal_strain.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// How much warmer patches are than where they have no stress: change + gradient . (x - point).
struct TemperatureChange {
  double change = 0;                                   ///< at the point, K
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< K/m
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     ///< m
  bool operator==(const TemperatureChange&) const = default;
};

/// A change of temperature in some patches. Several in one patch add up.
struct TemperatureLoad {
  std::string name;
  std::vector<PatchId> patches;
  TemperatureChange temperature;
};

/// The thermal strain of every patch; empty if there are no loads.
/// @throws Error invalid_argument  a patch that does not exist, or whose material has no expansion
std::vector<ThermalStrain> thermal_strains(const std::vector<TemperatureLoad>& loads,
                                           const std::vector<Material>& materials);

}  // namespace isopatch::iga
