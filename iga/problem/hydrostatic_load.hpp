#pragma once

#include <string>
#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// A liquid at rest beside some faces.
struct Liquid {
  double density = 0;                                         ///< kg/m^3
  Eigen::Vector3d surface = Eigen::Vector3d::Zero();          ///< a point of its free surface, m
  Eigen::Vector3d gravity = Eigen::Vector3d(0, 0, -9.80665);  ///< acceleration, m/s^2
  bool operator==(const Liquid&) const = default;
};

/// Pressure (Pa) of a liquid: density (x - surface) . gravity below the surface, nothing above it.
double pressure(const Liquid& liquid, const Eigen::Vector3d& place);

/// The pressure of a liquid on faces, or the part of them in a region, integrated up to the liquid's surface.
/// @throws Error invalid_argument  a density that is not positive, gravity of 0, or faces that it nowhere
/// wets
SurfaceLoad hydrostatic_load(std::string name, std::vector<geometry::PatchFace> faces, const Liquid& liquid,
                             const Discretization& discretization, const Region& region = {});

}  // namespace isopatch::iga
