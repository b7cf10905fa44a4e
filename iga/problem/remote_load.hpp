#pragma once

#include <optional>
#include <string>
#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// A force and a moment at a point that need not be on the part, carried to it by something that is not
/// modelled and as soft as the faces allow.
struct RemoteForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< on the part, N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< on the part, N m
  std::optional<Eigen::Vector3d> point = {};         ///< where the force acts, m; none: the faces' centroid
  bool operator==(const RemoteForce&) const = default;
};

/// The tractions t(x) = a + b x (x - c) with the force and the moment of a remote one: of all with these, the
/// ones that are least in the mean square, so the faces may deform (as RBE3 elements do, weighted by area).
///
/// Force and moment are so by the rule that loads are integrated with, so to round-off.
///
/// @throws Error invalid_argument  a force and a moment of 0, faces without area, or so narrow that they
///     cannot take the moment
SurfaceLoad remote_load(std::string name, std::vector<geometry::PatchFace> faces, const RemoteForce& remote,
                        const Discretization& discretization, const Region& region = {});

}  // namespace isopatch::iga
