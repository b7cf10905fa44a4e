#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/material/material.hpp"

namespace isopatch::app {

/// What a part weighs and how.
struct MassProperties {
  double mass = 0;                                   ///< kg
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of mass, m
  /// About the centre, along the axes, kg m^2: integral of density (r.r I - r r^T).
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// @param materials  one per patch
/// @return  nothing if a material has no density
/// @cost    quadrature on the faces of the model's own elements
std::optional<MassProperties> mass_properties(const geometry::MultiPatch& model,
                                              const std::vector<iga::Material>& materials);

}  // namespace isopatch::app
