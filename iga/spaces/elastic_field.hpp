#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/splines/nurbs.hpp"
#include "iga/material/material.hpp"
#include "iga/material/thermal_strain.hpp"

namespace isopatch::iga {

/// What is estimated of the error in each element of a patch, first direction fastest.
struct ElementErrors {
  Eigen::VectorXd energy;  ///< of the error, J
  Eigen::VectorXd stress;  ///< von Mises stress of the error, root mean square over the element, Pa
  /// Shares of the energy that finer elements along each direction would take away, (3, elements), J; none of
  /// results that were read from a file.
  Eigen::Matrix3Xd along = {};
};

/// A displacement on patches with their materials: all that post-processing needs.
struct ElasticField {
  std::vector<geometry::NurbsVolume> patches;  ///< geometry in the solution space
  std::vector<Eigen::Matrix3Xd> displacement;  ///< coefficients per patch, (3, control points), m
  std::vector<Material> materials;             ///< one per patch
  std::vector<ThermalStrain> thermal = {};     ///< one per patch, or none at all

  /// Of a patch, as a strain of 0 where there is none.
  ThermalStrain thermal_strain(std::size_t patch) const {
    return thermal.empty() ? ThermalStrain{} : thermal[patch];
  }
  std::vector<ElementErrors> errors = {};  ///< one per patch, or none where they are not estimated
};

/// All values at one point.
struct FieldValues {
  Eigen::Vector3d place;         ///< m
  Eigen::Vector3d displacement;  ///< m
  Eigen::Matrix3d strain;        ///< small strain, the thermal one included
  Eigen::Matrix3d stress;        ///< Pa
  double von_mises = 0;          ///< Pa
  double jacobian = 0;           ///< det J, m^3 per parameter^3
};

/// @param patch      index of the patch, from 0
/// @param parameter  in the domain of the patch; where the map is singular (on a collapsed edge), strain and
/// stress are
///                   those a thousandth of the way to the patch's middle
/// @cost             O((degree + 1)^3)
FieldValues evaluate(const ElasticField& field, int patch, const geometry::Parameter<3>& parameter);

/// sqrt(3/2 s:s) of the stress deviator s.
double von_mises(const Eigen::Matrix3d& stress);

/// Where a point of space lies in a field's undeformed patches.
struct Location {
  int patch = -1;
  geometry::Parameter<3> parameter;
  double distance = 0;  ///< from the point asked for to the point of the patch, m
};

/// The patch and parameter closest to a point.
/// @return  distance is 0 up to round-off for points inside; callers decide what distance is too far
/// @cost    eight points per element and a few Newton iterations in each patch whose box is near
Location locate(const ElasticField& field, const Eigen::Vector3d& place);

/// The same for each material that meets there, whose stresses differ: first what `locate` finds, then one
/// patch of every other material that comes within a distance of the point.
/// @param within  m
/// @cost    that of `locate`, twice where materials differ
std::vector<Location> locate_sides(const ElasticField& field, const Eigen::Vector3d& place, double within);

}  // namespace isopatch::iga
