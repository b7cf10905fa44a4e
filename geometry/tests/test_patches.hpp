#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry::test {

/// A volume of the given degrees and elements whose control points are the Greville points of the unit cube,
/// mapped; for a map of first order it is that map, exactly.
NurbsVolume mapped(const std::array<KnotVector, 3>& knots,
                   const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);

/// A trilinear box.
NurbsVolume box_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// An exact sector of a ring about the z axis: radius along direction 0, angle (less than pi) along 1, height
/// along 2.
NurbsVolume ring_sector(double inner, double outer, double from, double to, double height);

/// A closed ring in one patch, from four quarter arcs; angle along direction 1.
NurbsVolume closed_ring(double inner, double outer, double height);

/// The same volume with other directions: direction d of the result is direction order[d] of the input,
/// turned around if flip[d] is set.
NurbsVolume permuted(const NurbsVolume& volume, const std::array<int, 3>& order,
                     const std::array<bool, 3>& flip);

/// Number `index` of the 48 signed permutations of the directions.
NurbsVolume permuted(const NurbsVolume& volume, int index);

/// 2x2x2 boxes of different sizes that fill [0, 3] x [0, 2.5] x [0, 2]; the first direction runs fastest.
std::vector<NurbsVolume> eight_boxes();

}  // namespace isopatch::geometry::test
