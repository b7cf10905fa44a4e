#pragma once

#include <cstdint>
#include <functional>

#include "geometry/splines/nurbs.hpp"
#include "segmentation/parameterization/hex_solid.hpp"

namespace isopatch::segmentation::test {

/// The image of the unit cube under a map; its faces are parametrized as the map is.
HexSolid mapped_cube(const std::string& name,
                     const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);

/// A quarter of a tube about the z axis: radii 1 and 2, height 1.5.
HexSolid quarter_tube();
/// A bar 1 x 1 x 4, turned by 120 degrees from end to end.
HexSolid twisted_bar();
/// A cube with a hill on its top.
HexSolid hilly_cube();
/// A slab whose top and bottom are a plane region between two humps, trimmed out of larger planes: the blend
/// of its sides folds.
HexSolid trimmed_slab();
/// A straight hexahedron by its corners, with bilinear faces.
HexSolid straight(const std::string& name, const std::array<Eigen::Vector3d, 8>& corners);

/// A cube whose corners, edges and faces are moved at random by about `amount` of its size; cubic edges and
/// faces.
HexSolid random_hexahedron(std::uint32_t seed, double amount);

}  // namespace isopatch::segmentation::test
