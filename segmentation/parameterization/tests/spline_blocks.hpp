#pragma once

#include <functional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation::test {

/// A solid whose six faces are the sides of a volume, untrimmed.
geometry::Brep solid_of(const geometry::NurbsVolume& volume);

/// A volume on given knots whose control points are the images of the unit cube's Greville points.
geometry::NurbsVolume bent(const std::array<geometry::KnotVector, 3>& knots,
                           const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);

/// A block with a wavy top: plane faces all around, cut out of larger planes along the spline edges of the
/// top.
/// @param knots  of the top, which is extruded along y
geometry::Brep wavy_top_over_planes(const geometry::KnotVector& knots);

/// A bar with a square section that winds upwards around the z axis: turns of radius 1, section 0.2 x 0.2,
/// rise 0.5 a turn.
Eigen::Vector3d helix(const Eigen::Vector3d& parameter, double turns);

}  // namespace isopatch::segmentation::test
