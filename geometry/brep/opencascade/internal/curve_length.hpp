#pragma once

#include <Geom_Curve.hxx>

#include "geometry/brep/measure.hpp"

namespace isopatch::geometry {

/// Length of a curve between two parameters, in its units, by adaptive quadrature from knot to knot.
/// @param relative  largest error to stop at, as a share of the length
Measure curve_length(const Handle(Geom_Curve) & curve, double first, double last, double relative);

}  // namespace isopatch::geometry
