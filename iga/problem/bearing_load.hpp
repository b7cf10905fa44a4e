#pragma once

#include <string>
#include <vector>

#include "iga/problem/problem.hpp"

namespace isopatch::iga {

/// What a pin presses against a bore, or a housing against a shaft: a pressure that is largest where the
/// faces look against the force and falls with the cosine to nothing at a quarter turn, p = max(0, -n . g),
/// with g such that the pressures add up to the force.
///
/// On a whole bore g is along the force and p = F cos(angle) / (length radius pi / 2); on part of one, or on
/// a cone, g turns until the resultant is the force. It is so by the rule that loads are integrated with, so
/// to round-off.
///
/// @param force  on the part, N
/// @throws Error invalid_argument  a force of 0, or one that no pressure on these faces adds up to: along the
///     axis of a cylinder, or away from all of it
SurfaceLoad bearing_load(std::string name, std::vector<geometry::PatchFace> faces,
                         const Eigen::Vector3d& force, const Discretization& discretization,
                         const Region& region = {});

}  // namespace isopatch::iga
