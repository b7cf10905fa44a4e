#pragma once

#include <optional>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// A solid as a hexahedron in its middle and six around it.
struct BallCells {
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  int spans = 0;                  ///< of the outer sides, along either direction
};

/// Whether a solid has one face, which closes on itself as a sphere does.
bool is_one_closed_face(const geometry::Brep& solid);

/// Divides a solid with one smooth face that is seen from the solid's centre of gravity all around:
/// ellipsoids, pebbles, what a spline wraps. Each outer side is a spline of degree 5 through points of the
/// face, within 2e-6 of the solid's size.
/// @return  nothing for a solid with other than one closed face
/// @throws Error unsupported  the face is not seen from there, or has an edge or a tip: names the place
/// @cost  some thousand projections on the face, ten times as many where its curvature jumps
std::optional<BallCells> ball_cells(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
