#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/splines/knot_vector.hpp"

namespace isopatch::segmentation {

/// A surface that is a polynomial spline in its domain's own parameters.
struct SplineSurfaceKnots {
  std::array<geometry::KnotVector, 2> along;  ///< by direction of the domain
};

/// Knots over [0, 1] of an edge whose curve is a polynomial spline in the edge's own parameter; nothing for
/// lines, arcs and rational curves.
std::optional<geometry::KnotVector> spline_knots(const geometry::Brep& brep, EdgeId edge);

/// Of each face, the knots of its surface where that is a polynomial spline in the face's own domain (also an
/// extruded one); nothing for planes, cylinders and whatever is rational or has no spline form.
std::vector<std::optional<SplineSurfaceKnots>> spline_knots(const geometry::Brep& brep);

}  // namespace isopatch::segmentation
