#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "geometry/brep/read_brep.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation::test {

using Map = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// The solid that a volume fills: six untrimmed faces, sewn; by side.
geometry::BrepFile solid_of(const std::string& name, const geometry::NurbsVolume& volume);

/// A spline volume through the images of the unit cube's Greville points.
geometry::NurbsVolume interpolated(const std::array<geometry::KnotVector, 3>& knots, const Map& map);

/// The image of the unit cube under a map, to about 1e-5 if the map bends moderately.
geometry::BrepFile mapped_cube(const std::string& name, const Map& map);

/// A quarter of a tube about the z axis: radii 1 and 2, height 1.5; exact.
geometry::BrepFile quarter_tube();
/// A bar 1 x 1 x 4, turned by 120 degrees from end to end.
geometry::BrepFile twisted_bar();
/// A cube with a hill on its top.
geometry::BrepFile hilly_cube();
/// A slab whose top and bottom are a plane region between two humps, trimmed out of larger planes: the blend
/// of its sides folds.
geometry::BrepFile trimmed_slab();
/// A straight hexahedron by its corners, with bilinear faces.
geometry::BrepFile straight(const std::string& name, const std::array<Eigen::Vector3d, 8>& corners);
/// A brick by its lowest corner and its size.
geometry::BrepFile brick(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& size);

/// A cube whose corners, edges and faces are moved at random by about `amount` of its size; cubic edges and
/// faces.
geometry::BrepFile random_hexahedron(std::uint32_t seed, double amount);

}  // namespace isopatch::segmentation::test
