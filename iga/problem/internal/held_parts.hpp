#pragma once

#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/problem/sprung_point.hpp"

namespace isopatch::iga {

/// How much stiffer springs that stand for a hold are than the part, whose stiffness is about Young's modulus
/// times its size, and over its size per area.
inline constexpr double stiffer_than_part = 1e4;

/// The control points on a side whose functions have their Greville point, where they are largest or nearly,
/// in a region: holding these holds what is in it, up to half an element at the rim.
///
/// Of a displacement that grows linearly from the rim on, coefficients grow so from the last held Greville
/// point. Holding all functions that reach into the region would move the rim by (degree + 1) / 2 elements.
/// @return  indices among the control points of the patch
std::vector<int> held_control_points(const geometry::NurbsVolume& patch, geometry::Side side,
                                     const Region& region);

/// The springs of an elastic support in its region, at the Gauss points there.
/// @throws Error invalid_argument  stiffnesses that are none, a region that none of the faces reaches into
std::vector<SprungPoint> springs_in_region(const ElasticityProblem& problem, const Support& support,
                                           const ElasticSupport& springs);

/// The springs by which a support holds its points; none without.
/// @throws Error invalid_argument  anything but a PrescribedDisplacement of 0
std::vector<SprungPoint> held_points(const ElasticityProblem& problem, const Support& support);

}  // namespace isopatch::iga
