#pragma once

#include "geometry/brep/brep.hpp"
#include "geometry/brep/carrier_solid.hpp"

namespace isopatch::geometry {

/// The solid. Its faces, edges and vertices have the numbers of the input, but for poles, which a Brep leaves
/// out, after which edges count on.
/// @param tolerance  between edges and their points, m
/// @throws Error invalid_argument  a number out of range, a face without a spline whose carrier is none of
/// the five kinds
/// @throws Error unsupported  the CAD library cannot do it
Brep make_brep(const CarrierSolid& solid, double tolerance);

}  // namespace isopatch::geometry
