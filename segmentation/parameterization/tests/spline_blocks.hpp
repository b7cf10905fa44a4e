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

/// A plane curve through points of a map of [0, 1], in the domain of a plane.
geometry::NurbsCurve outline_curve(const geometry::KnotVector& knots,
                                   const std::function<Eigen::Vector2d(double)>& map);

/// A slab over a plane region: south, north (along x), west and east (along y) outlines within the unit
/// square; top and bottom are trimmed out of unit squares, the walls are extruded.
geometry::Brep slab_between(const geometry::NurbsCurve& south, const geometry::NurbsCurve& north,
                            const geometry::NurbsCurve& west, const geometry::NurbsCurve& east,
                            double height);

/// A block with a wavy top: plane faces all around, cut out of larger planes along the spline edges of the
/// top.
/// @param knots  of the top, which is extruded along y
geometry::Brep wavy_top_over_planes(const geometry::KnotVector& knots);

/// A bar with a square section that winds upwards around the z axis: turns of radius 1, section 0.2 x 0.2,
/// rise 0.5 a turn.
Eigen::Vector3d helix(const Eigen::Vector3d& parameter, double turns);

}  // namespace isopatch::segmentation::test
