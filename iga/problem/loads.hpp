#pragma once

#include <Eigen/Core>
#include <functional>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// Load vector of all surface, volume and point loads, per node before any coupling. (3, nodes), N
/// @param points  Gauss points per element and direction in volumes; 0: degree + 1. Faces have degree + 6.
/// @throws Error invalid_argument  a face that is not on the boundary, a patch that does not exist, a load
/// that
///                                 is not finite at a point
Eigen::Matrix3Xd load_vector(const ElasticityProblem& problem, int points = 0);

/// The force of a volume load, integrated as the load vector is. N
Eigen::Vector3d total_force(const VolumeLoad& load, const Discretization& discretization, int points = 0);

/// Area of some faces, or of the part of them in a region, by the rule that loads are integrated with. m^2
double area_of(const std::vector<geometry::NurbsVolume>& patches,
               const std::vector<geometry::PatchFace>& faces, const Region& region = {});

/// Integral of a function of place and outward normal over one face of a patch, or the part of it in a
/// region, against its trace functions.
/// @return  (3, control points of the face), in the order of geometry::face_control_points
Eigen::Matrix3Xd face_load(
    const geometry::NurbsVolume& patch, geometry::Side side,
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>& traction,
    const Region& region = {});

}  // namespace isopatch::iga
