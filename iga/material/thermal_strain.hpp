#pragma once

#include <Eigen/Core>

namespace isopatch::iga {

/// The strain that a temperature alone causes, the same in all directions and linear in the place:
/// (at_origin + gradient . x) I.
struct ThermalStrain {
  double at_origin = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< 1/m

  double at(const Eigen::Vector3d& place) const { return at_origin + gradient.dot(place); }
  bool operator==(const ThermalStrain&) const = default;
};

}  // namespace isopatch::iga
