#pragma once

#include <Eigen/Core>

namespace isopatch::iga {

/// Principal stresses and their directions.
struct PrincipalStresses {
  Eigen::Vector3d values;      ///< Pa, the largest first
  Eigen::Matrix3d directions;  ///< unit columns, right-handed, in the order of the values
};

/// @param stress  symmetric, Pa
PrincipalStresses principal_stresses(const Eigen::Matrix3d& stress);

/// The values alone, the largest first. Pa
Eigen::Vector3d principal_values(const Eigen::Matrix3d& stress);

/// The equivalent stress of Tresca: the largest principal stress minus the smallest. Pa
double tresca(const Eigen::Matrix3d& stress);

/// By how much a von Mises stress may grow until it is the yield stress; infinite without stress.
/// @param yield  above 0, Pa
double safety_factor(double von_mises, double yield);

}  // namespace isopatch::iga
